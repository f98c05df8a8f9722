// Buttons, keys and the mouse; and what tests may ask.
import { Vector3 } from "three";
import { App } from "./app";
import { cornersOf } from "./boxes";
import { byId } from "./dom";
import { install } from "./keyboard";
import { Keyring } from "./keyring";
import { Rest } from "./rest";

const CLICK_PX = 4;

const keys = new Keyring(byId<HTMLDialogElement>("key"));
const app = new App(new Rest(keys), keys);
const list = byId<HTMLDialogElement>("keys");
const { attempt, placing, view } = app;

const acts = {
  place: () => attempt(() => app.startPlacing()),
  reset: () => app.startReset(),
  close: () => attempt(() => app.closeSession()),
  frame: () => app.centre(),
  up: () => app.turnUp(),
  play: () => attempt(() => app.togglePlaying()),
  help: () => list.showModal(),
};
for (const [id, act] of Object.entries(acts)) byId(id).onclick = act;

install(
  [
    { key: "n", does: "place a box, open a session", act: acts.place },
    { key: "r", does: "re-initialise the session", act: acts.reset },
    { key: "1", does: "move the box", act: () => placing.setMode("translate") },
    { key: "2", does: "turn the box", act: () => placing.setMode("rotate") },
    { key: "3", does: "stretch the box", act: () => placing.setMode("scale") },
    { key: "Enter", does: "open, or re-initialise", act: () => attempt(() => app.confirm()) },
    { key: "Escape", does: "leave the box", act: () => app.cancel() },
    { key: " ", does: "play or pause", act: acts.play },
    { key: "f", does: "centre the object", act: acts.frame },
    { key: "u", does: "change which way is up", act: acts.up },
    { key: "ArrowUp", does: "session above", act: () => app.step(-1) },
    { key: "ArrowDown", does: "session below", act: () => app.step(1) },
    { key: "?", does: "this list", act: acts.help },
  ],
  list,
);

byId("placing").addEventListener("submit", (event) => {
  event.preventDefault();
  attempt(() => app.confirm());
});

const play = (file: File | undefined) => {
  if (file === undefined) return;
  attempt(async () => app.openRecording(file.name.replace(/\.(npz|mcap)$/, ""), await file.arrayBuffer()));
};
byId<HTMLInputElement>("file").onchange = ({ target }) => play((target as HTMLInputElement).files?.[0]);
for (const kind of ["dragover", "dragleave", "drop"] as const) {
  document.addEventListener(kind, (event) => {
    event.preventDefault();
    document.body.classList.toggle("dragging", kind === "dragover");
  });
}
document.addEventListener("drop", (event) => play(event.dataTransfer?.files[0]));

// A click puts the box there; a drag turns the view, or pulls the box by its handles.
let pressed = [0, 0];
byId("canvas").addEventListener("pointerdown", ({ offsetX, offsetY }) => (pressed = [offsetX, offsetY]));
byId("canvas").addEventListener("pointerup", ({ offsetX, offsetY }) => {
  const dragged = Math.hypot(offsetX - pressed[0], offsetY - pressed[1]) > CLICK_PX;
  if (!placing.active || placing.grabbed || dragged) return;
  const place = view.pick(offsetX, offsetY);
  if (place !== null) placing.moveTo(place);
});

Object.assign(window, {
  captra: {
    camera: () => ({
      projection: view.camera.projectionMatrix.elements,
      world: view.camera.matrixWorldInverse.elements,
    }),
    project: (x: number, y: number, z: number) => view.project(new Vector3(x, y, z)),
    corners: () =>
      (placing.active ? placing.parts : view.object.parts).map((part) => cornersOf(part).map((p) => view.project(p))),
    points: () => view.cloud.count,
    trail: () => view.trailLength,
    placed: () => placing.parts,
    shown: () => (view.object.group.visible ? view.object.parts : []),
    frame: () => app.deck.player?.frame ?? 0,
  },
});
