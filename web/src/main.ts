// The live page: what is looked at, what can be done with it, and the keys that do it.
import { Vector3 } from "three";
import { cornersOf } from "./boxes";
import { Charts } from "./charts";
import { quantize } from "./cloud";
import { Placing, typicalParts, WHOLE, type Mode } from "./placing";
import { Player } from "./player";
import { metres, readRecording } from "./recording";
import * as rest from "./rest";
import { View } from "./scene";
import { Stream } from "./stream";
import { COLOURS, type Category, type CloudMessage, type Message, type Part, type Result, type Summary } from "./types";

const $ = <T extends HTMLElement = HTMLElement>(id: string): T => document.getElementById(id) as T;
type Scene = { kind: "none" } | { kind: "session"; id: string } | { kind: "preview"; name: string } | { kind: "recording" };
const MODES: [Mode, string, string][] = [["translate", "Move", "1"], ["rotate", "Turn", "2"], ["scale", "Stretch", "3"]];
const DEGREES = 180 / Math.PI;

let scene: Scene = { kind: "none" };
let sessions: Summary[] = [], previews: string[] = [], known: Category[] = [], files: { name: string }[] = [];
let result: Result | null = null, player: Player | null = null, resetting = false, chosenByHand = false;
const rates = new Map<string, { processed: number; time: number; fps: number }>();
let shownBefore = "";

const view = new View($<HTMLCanvasElement>("canvas"), $("labels"));
const charts = new Charts({ confidence: $("confidence-now"), latency: $("latency-now") }, [$("confidence"), $("latency")]);
const placing = new Placing(view, $("canvas"), () => showPlacing());
const stream = new Stream(onMessage, onCloud, (live) => {
  $("link").className = live ? "live" : "";
  $("link").textContent = live ? "live" : "no connection";
  if (live) loadLists();
});

function fail(error: unknown): void {
  $("toast").textContent = (error as Error).message ?? String(error);
  $("toast").className = "on";
  setTimeout(() => ($("toast").className = ""), 6000);
}
const attempt = (work: () => Promise<unknown>) => () => { work().catch(fail); };

async function loadLists(): Promise<void> {
  [known, files] = await Promise.all([rest.categories(), rest.recordings()]);
  showLists();
}

function onMessage(message: Message): void {
  if (message.type === "overview") {
    ({ sessions, previews } = message);
    for (const { session_id, processed } of sessions) {
      const last = rates.get(session_id), time = message.time_s;
      if (last === undefined) rates.set(session_id, { processed, time, fps: 0 });
      else if (time - last.time >= 0.9) rates.set(session_id, { processed, time, fps: (processed - last.processed) / (time - last.time) });
    }
    if (scene.kind === "none" && !chosenByHand && sessions.length > 0) look({ kind: "session", id: sessions[sessions.length - 1].session_id });
    showLists();
    showState();
  } else if (message.type === "result") take(message.result);
  else if (message.type === "refused") fail(message.detail);
  else if (message.event.kind === "closing" && scene.kind === "session" && scene.id === message.event.session_id) {
    fail(`The session is closed: ${message.event.detail ?? message.event.reason}`);
    look({ kind: "none" });
  }
}

function onCloud(message: CloudMessage): void {
  const current = scene.kind === "session" ? `session/${scene.id}` : scene.kind === "preview" ? `preview/${scene.name}` : "";
  if (message.scene !== current) return;
  view.cloud.show(message);
  if (message.result !== null) showObject(message.result);
  view.frameOnce();
  view.draw();
  showState();
}

function take(next: Result): void {
  if (scene.kind !== "session" || scene.id !== next.session_id) return;
  result = next;
  charts.add(next);
  charts.show(next.session_id);
  if (next.seq !== null) view.follow(new Vector3(...next.parts[0].translation));
  if (next.seq === null || view.cloud.count === 0) showObject(next);
  showState();
}

function showObject(shown: Result): void {
  view.object.group.visible = !placing.active;
  view.object.show(shown.parts, COLOURS[shown.state]);
  view.draw();
}

function look(next: Scene, keepCloud = false): void {
  scene = next;
  result = null;
  view.object.group.visible = false;
  view.forgetTrail();
  if (placing.active) placing.end();
  if (!keepCloud) { view.cloud.hide(); view.frameAgain(); }
  if (next.kind !== "recording" && !(next.kind === "session" && player?.session === next.id)) { player?.pause(); player = null; }
  stream.watch(next.kind === "session" ? { session: next.id } : next.kind === "preview" ? { preview: next.name } : {});
  charts.show(next.kind === "session" ? next.id : null);
  showLists(); showState(); showPlacing(); showPlayer();
  view.draw();
}
const choose = (next: Scene) => { chosenByHand = true; look(next); };

async function openRecording(name: string, file: ArrayBuffer): Promise<void> {
  const recording = await readRecording(name, file);
  if (known.length === 0) await loadLists();
  const category = known.find((each) => each.name === recording.category);
  if (category === undefined) throw new Error(`${name} is of ${recording.category}, which this service does not know`);
  chosenByHand = true;
  player?.pause();
  player = new Player(recording, null, () => showPlayer(), fail);
  look({ kind: "recording" });
  view.cloud.show(quantize(metres(recording.clouds[0])));
  view.frameOnce();
  begin(category, recording.init.map((part, i) => ({ ...part, name: category.parts[i] })), false);
  showPlayer();
}

function begin(category: Category, parts: Part[], again: boolean): void {
  resetting = again;
  view.object.group.visible = false;
  placing.start(category, parts);
  showState();
}

function startPlacing(): void {
  const category = known.find((each) => each.trackable && each.name === "mug") ?? known.find((each) => each.trackable);
  if (category === undefined) return fail("this service has no model: export one, or set CAPTRA_MODELS_DIR");
  if (view.cloud.count === 0) return fail("there is no cloud yet: choose a session, a camera or a recording first");
  begin(category, typicalParts(category, view.cloud.median(), view.up), false);
}

function startReset(): void {
  const summary = sessions.find((each) => scene.kind === "session" && each.session_id === scene.id);
  const category = known.find((each) => each.name === summary?.category);
  if (result === null || category === undefined) return;
  begin(category, result.parts, true);
}

async function confirmPlacing(): Promise<void> {
  if (!placing.active) return;
  const { category, parts } = placing, from = scene;
  if (resetting && scene.kind === "session") {
    const fresh = await rest.reset(scene.id, parts);
    player?.restarted();
    placing.end();
    view.forgetTrail();
    take(fresh);
    showObject(fresh);
  } else {
    const { session_id } = await rest.open(category!.name, parts);
    if (player !== null) player.session = session_id;
    if (from.kind === "preview") stream.tell({ type: "feed", preview: from.name, session: session_id });
    look({ kind: "session", id: session_id }, true);
  }
  showPlacing(); showState(); showPlayer();
}

async function toggle(): Promise<void> {
  if (player === null) return;
  if (player.playing) return player.pause();
  if (player.session === null) {
    if (!placing.active) throw new Error("the session is closed: choose the recording again");
    await confirmPlacing();
  }
  if (player.ended) { // from the beginning, from where the object was then
    const { init } = player.recording;
    await rest.reset(player.session!, init as Part[]);
    player.restarted();
    player.frame = 0;
    view.forgetTrail();
  }
  player.play().catch(fail);
}

function cancel(): void {
  if (!placing.active) return;
  placing.end();
  if (scene.kind === "recording") look({ kind: "none" });
  view.object.group.visible = result !== null;
  showPlacing(); showState(); showPlayer();
}

function element<K extends keyof HTMLElementTagNameMap>(tag: K, properties: Partial<HTMLElementTagNameMap[K]> = {}, ...children: (Node | string)[]): HTMLElementTagNameMap[K] {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

function card(title: string, side: string, detail: string, on: boolean, act: () => void, state?: string, bar?: number): HTMLElement {
  const made = element("button", { className: `card${on ? " on" : ""}`, onclick: act }, element("span", { className: "dot" }), element("strong", { textContent: title, title }), element("em", { textContent: side }), element("small", { textContent: detail }));
  if (state !== undefined) made.dataset.state = state;
  if (bar !== undefined) {
    const fill = element("i");
    fill.style.width = `${100 * bar}%`;
    made.append(element("span", { className: "bar" }, fill));
  }
  return made;
}

function showLists(): void {
  const now = JSON.stringify([sessions.map((s) => [s.session_id, s.state, s.confidence, s.latency_ms, s.rejected, rates.get(s.session_id)?.fps]), previews, files, known.length, scene, player?.recording.name]);
  if (now === shownBefore) return; // what is under a finger is not replaced for nothing
  shownBefore = now;
  $("sessions").replaceChildren(...(sessions.length > 0 ? sessions.map((s) => {
    const detail = `${(rates.get(s.session_id)?.fps ?? 0).toFixed(0)} fps · ${s.latency_ms.toFixed(0)} ms${s.rejected > 0 ? ` · ${s.rejected} rejected` : ""}`;
    const made = card(s.category.replaceAll("_", " "), `${s.state} ${s.confidence.toFixed(2)}`, detail, scene.kind === "session" && scene.id === s.session_id, () => choose({ kind: "session", id: s.session_id }), s.state, s.confidence);
    made.dataset.session = s.session_id;
    return made;
  }) : [element("p", { textContent: "None yet. Play a recording below, or let a client POST /v1/sessions." })]));
  $("previews").replaceChildren(...(previews.length > 0 ? previews.map((name) => card(name, "", "clouds without a session", scene.kind === "preview" && scene.name === name, () => choose({ kind: "preview", name }))) : [element("p", {}, "Clouds put on ", element("code", { textContent: "captra/default/previews/NAME" }), " show up here.")]));
  const trackable = new Set(known.filter((each) => each.trackable).map((each) => each.name));
  $("recordings").replaceChildren(...files.map(({ name }) => {
    const [category, ...rest_] = name.split("__"), tracked = trackable.has(category);
    const made = card(category.replaceAll("_", " "), "", tracked ? rest_.slice(1).join(", ").replaceAll(/[-_]/g, " ") || name : "no model of it here", player?.recording.name === name, attempt(async () => openRecording(name, await rest.recordingFile(name))));
    (made as HTMLButtonElement).disabled = !tracked;
    made.dataset.recording = name;
    return made;
  }));
}

function showState(): void {
  const summary = sessions.find((each) => scene.kind === "session" && each.session_id === scene.id);
  const state = result?.state ?? summary?.state;
  const name = placing.active ? (resetting ? `New pose of the ${placing.category!.name}` : "A new session") : scene.kind === "session" ? summary?.category ?? "" : scene.kind === "preview" ? scene.name : scene.kind === "recording" ? player?.recording.category ?? "" : "";
  const hint = placing.active ? "click the cloud to put the box there" : state === "lost" ? "lost: re-initialise it (R)" : state === undefined ? "" : `${state} ${(result?.confidence ?? summary!.confidence).toFixed(2)}`;
  const badge = element("span", { textContent: hint });
  $("title").replaceChildren(name.replaceAll("_", " "), badge);
  if (state !== undefined && !placing.active) $("title").dataset.state = state; else delete $("title").dataset.state;
  $("reset").hidden = $("close").hidden = scene.kind !== "session" || placing.active;
  $("place").hidden = placing.active || view.cloud.count === 0;
  $("reset").classList.toggle("primary", state === "lost");
  const empty = $("empty"), waiting = scene.kind === "session" && view.cloud.count === 0;
  const say = (title: string, text: string) => empty.replaceChildren(element("div", {}, element("strong", { textContent: title }), text));
  if (scene.kind === "none") say("Nothing to look at yet", sessions.length > 0 ? "Choose a session on the left." : "Play a recording from the list on the left, or drop one anywhere.");
  else if (waiting && result?.seq == null) say("Waiting for the first cloud", "The session is open. Put clouds on its key, or POST them to its frames.");
  else empty.replaceChildren();
  const rows = result !== null && !placing.active ? result.parts.map((part) => element("tr", {}, element("th", { textContent: part.name.replaceAll("_", " ") }), element("td", { textContent: part.translation.map((v) => v.toFixed(3)).join("  ") + " m" }), element("td", { textContent: part.size.map((v) => (100 * v).toFixed(1)).join(" × ") + " cm" }))) : [];
  const joints = result !== null && !placing.active ? result.joints.map((joint) => element("tr", {}, element("th", { textContent: joint.name.replaceAll("_", " ") }), element("td", { textContent: joint.kind === "revolute" ? `${(joint.value * DEGREES).toFixed(1)}°` : `${(100 * joint.value).toFixed(1)} cm` }))) : [];
  $("parts").replaceChildren(...(rows.length > 0 ? [element("table", {}, ...rows, ...joints)] : []));
}

function showPlacing(): void {
  const form = $<HTMLFormElement>("placing");
  form.hidden = !placing.active;
  if (!placing.active || form.contains(document.activeElement) && document.activeElement instanceof HTMLInputElement) return;
  const fixed = resetting || scene.kind === "recording";
  const select = element("select", { id: "category", disabled: fixed, onchange: () => {
    const category = known.find((each) => each.name === select.value)!;
    begin(category, typicalParts(category, new Vector3(...placing.parts[0].translation), view.up), false);
  } }, ...known.map((each) => element("option", { value: each.name, textContent: each.name.replaceAll("_", " ") + (each.trackable ? "" : " (no model here)"), disabled: !each.trackable, selected: each.name === placing.category!.name })));
  const index = Math.max(0, placing.selected), part = placing.parts[index];
  const field = (name: "translation" | "size", axis: number) => element("input", { type: "number", step: name === "size" ? "0.5" : "1", value: (100 * part[name][axis]).toFixed(1), ariaLabel: `${name} ${"xyz"[axis]}, cm`, onchange: (event) => placing.set(index, name, axis, Number((event.target as HTMLInputElement).value) / 100) });
  const several = placing.parts.length > 1;
  const chooser = element("select", { onchange: () => placing.select(Number(chooser.value)) }, element("option", { value: String(WHOLE), textContent: "all parts together", selected: placing.selected === WHOLE }), ...placing.parts.map((each, i) => element("option", { value: String(i), textContent: each.name.replaceAll("_", " "), selected: placing.selected === i })));
  form.replaceChildren(
    element("label", {}, "Category", select),
    ...(several ? [element("label", {}, "Part", chooser)] : []),
    element("div", { className: "row" }, ...MODES.map(([mode, name, key]) => element("button", { type: "button", className: placing.mode === mode ? "on" : "", onclick: () => placing.setMode(mode) }, name, element("kbd", { textContent: key })))),
    ...(placing.selected === WHOLE ? [] : (["translation", "size"] as const).map((name) => element("label", {}, name === "size" ? "Size x, y, z (cm)" : "Centre x, y, z (cm)", element("div", { className: "row" }, ...[0, 1, 2].map((axis) => field(name, axis)))))),
    element("p", { textContent: `y points up the object${placing.category!.name === "mug" ? ", the handle to +x (red)" : ""}. 5° and 3 cm are close enough.${placing.category!.surroundings ? "" : " Clouds have to hold this object alone."}` }),
    element("div", { className: "row" }, element("button", { type: "button", onclick: cancel }, "Cancel", element("kbd", { textContent: "Esc" })), element("button", { id: "confirm", className: "primary", type: "submit" }, resetting ? "Re-initialise" : "Open session")),
  );
}

function showPlayer(): void {
  $("player").hidden = player === null;
  if (player === null) return;
  const { clouds, stamps } = player.recording, seconds = (i: number) => (Number(stamps[i] - stamps[0]) / 1e9).toFixed(1);
  const label = player.playing ? "Pause" : player.ended ? "Play again" : "Play";
  if ($("play").dataset.label !== label) $("play").replaceChildren(label, element("kbd", { textContent: "Space" }));
  $("play").dataset.label = label;
  $<HTMLProgressElement>("progress").value = (player.frame + 1) / clouds.length;
  $("clock").textContent = `${seconds(player.frame)} / ${seconds(stamps.length - 1)} s`;
}

async function drop(file: File): Promise<void> {
  await openRecording(file.name.replace(/\.npz$/, ""), await file.arrayBuffer());
}

function centre(): void {
  const parts = placing.active ? placing.parts : result?.parts;
  if (parts === undefined) { view.frameAgain(); return view.frameOnce(); }
  view.lookAt(new Vector3(...parts[parts.length - 1].translation), 3.2 * Math.max(...parts.flatMap((part) => part.size)));
}

function setUp(): void {
  view.setUp(view.up === "camera" ? "robot" : "camera");
  $("up").firstChild!.textContent = view.up === "camera" ? "Up −Y " : "Up +Z ";
}

function step(by: number): void {
  const at = sessions.findIndex((each) => scene.kind === "session" && each.session_id === scene.id), next = sessions[Math.min(sessions.length - 1, Math.max(0, at + by))];
  if (next !== undefined) choose({ kind: "session", id: next.session_id });
}

const KEYS: [string, string, () => void][] = [
  ["n", "place a box, open a session", startPlacing], ["r", "re-initialise the session", startReset], ["1", "move the box", () => placing.setMode("translate")],
  ["2", "turn the box", () => placing.setMode("rotate")], ["3", "stretch the box", () => placing.setMode("scale")], ["Enter", "open, or re-initialise", attempt(confirmPlacing)],
  ["Escape", "leave the box", cancel], [" ", "play or pause", attempt(toggle)], ["f", "centre the object", centre], ["u", "change which way is up", setUp],
  ["ArrowUp", "session above", () => step(-1)], ["ArrowDown", "session below", () => step(1)], ["?", "this list", () => $<HTMLDialogElement>("keys").showModal()],
];
$("keys").replaceChildren(element("table", {}, ...KEYS.map(([key, does]) => element("tr", {}, element("td", {}, element("kbd", { textContent: key === " " ? "Space" : key })), element("td", { textContent: does })))));
document.addEventListener("keydown", (event) => {
  if (event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement || event.ctrlKey || event.metaKey || event.altKey) return;
  const found = KEYS.find(([key]) => key === event.key);
  if (found === undefined || $<HTMLDialogElement>("keys").open) return;
  event.preventDefault();
  found[2]();
});
$<HTMLInputElement>("file").onchange = ({ target }) => { const file = (target as HTMLInputElement).files?.[0]; if (file) attempt(() => drop(file))(); };
$("placing").addEventListener("submit", (event) => { event.preventDefault(); attempt(confirmPlacing)(); });
for (const [id, act] of Object.entries({ place: startPlacing, reset: startReset, frame: centre, up: setUp, play: attempt(toggle), help: () => $<HTMLDialogElement>("keys").showModal(), close: attempt(async () => { if (scene.kind === "session") await rest.close(scene.id); }) })) $(id).onclick = act;
let pressed: [number, number] = [0, 0];
$("canvas").addEventListener("pointerdown", (event) => (pressed = [event.offsetX, event.offsetY]));
$("canvas").addEventListener("pointerup", (event) => {
  if (!placing.active || placing.grabbed || Math.hypot(event.offsetX - pressed[0], event.offsetY - pressed[1]) > 4) return;
  const place = view.pick(event.offsetX, event.offsetY);
  if (place !== null) placing.moveTo(place);
});
for (const kind of ["dragover", "dragleave", "drop"]) document.addEventListener(kind, (event) => { event.preventDefault(); document.body.classList.toggle("dragging", kind === "dragover"); });
document.addEventListener("drop", (event) => { const file = (event as DragEvent).dataTransfer?.files[0]; if (file) attempt(() => drop(file))(); });
showLists(); showState();

// For tests and the curious: what is drawn, and where.
(window as unknown as { captra: object }).captra = {
  corners: () => (placing.active ? placing.parts : view.object.parts).map((part) => cornersOf(part).map((corner) => view.project(corner))),
  project: (x: number, y: number, z: number) => view.project(new Vector3(x, y, z)),
  camera: () => ({ projection: view.camera.projectionMatrix.elements, world: view.camera.matrixWorldInverse.elements }),
  points: () => view.cloud.count, trail: () => view.trailLength, parts: () => placing.parts, shown: () => view.object.parts, boxShown: () => view.object.group.visible,
};
