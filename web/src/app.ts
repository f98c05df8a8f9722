// What the page looks at and what can be done with it.
import { Vector3 } from "three";
import { showEmpty, showParts, showTitle } from "./caption";
import { Charts } from "./charts";
import { quantize } from "./cloud";
import { byId } from "./dom";
import { Histories } from "./history";
import type { Keyring } from "./keyring";
import { Placing, typicalParts } from "./placing";
import { showForm } from "./placing_form";
import { Player } from "./player";
import { showPlayer } from "./player_bar";
import { metres, readRecording } from "./recording";
import type { Rest } from "./rest";
import { View } from "./scene";
import { Sidebar } from "./sidebar";
import { Stream, type Listener } from "./stream";
import { COLOURS, NOTHING } from "./types";
import type { Category, CloudMessage, Message, Part, Result, Scene, Summary } from "./types";

const TOAST_MS = 6000;
const CLOSE_UP = 3.2;

export class App implements Listener {
  readonly view = new View(byId<HTMLCanvasElement>("canvas"), byId("labels"));
  readonly placing = new Placing(this.view, byId("canvas"), () => this.showForm());
  player: Player | null = null;
  private charts = new Charts(byId);
  private histories = new Histories();
  private sidebar = new Sidebar({
    look: (scene) => this.choose(scene),
    openRecording: (name) => this.fetchRecording(name),
  });
  private stream: Stream;
  private scene: Scene = NOTHING;
  private sessions: Summary[] = [];
  private previews: string[] = [];
  private known: Category[] = [];
  private recordings: string[] = [];
  private result: Result | null = null;
  private resetting = false;
  private chosenByHand = false;

  constructor(
    private rest: Rest,
    keys: Keyring,
  ) {
    this.stream = new Stream(keys, this);
    this.stream.start();
    this.showAll();
  }

  // Runs what a hand asked for; what goes wrong is told.
  attempt = (work: () => Promise<unknown> | void): void => {
    Promise.resolve().then(work).catch(this.fail);
  };

  fail = (error: unknown): void => {
    const toast = byId("toast");
    toast.textContent = error instanceof Error ? error.message : String(error);
    toast.className = "on";
    setTimeout(() => (toast.className = ""), TOAST_MS);
  };

  async admitted(): Promise<void> {
    const [known, recordings] = await Promise.all([this.rest.categories(), this.rest.recordings()]);
    this.known = known;
    this.recordings = recordings.map(({ name }) => name);
    this.showLists();
  }

  onLink(live: boolean): void {
    byId("link").className = live ? "live" : "";
    byId("link").textContent = live ? "live" : "no connection";
  }

  onMessage(message: Message): void {
    switch (message.type) {
      case "overview":
        return this.survey(message.sessions, message.previews, message.time_s);
      case "result":
        return this.take(message.result);
      case "refused":
        return this.fail(message.detail);
      case "event": {
        const { kind, session_id, reason, detail } = message.event;
        if (kind !== "closing" || session_id !== this.sessionId) return;
        this.fail(`The session is closed: ${detail ?? reason}`);
        this.look(NOTHING);
      }
    }
  }

  onCloud(message: CloudMessage): void {
    if (message.scene !== this.sceneName) return;
    this.view.cloud.show(message);
    if (message.result !== null) this.showObject(message.result);
    this.view.frameOnce();
    this.view.draw();
    this.showState();
  }

  async openRecording(name: string, file: ArrayBuffer): Promise<void> {
    const recording = await readRecording(name, file);
    if (this.known.length === 0) await this.admitted();
    const category = this.known.find((each) => each.name === recording.category);
    if (category === undefined)
      throw new Error(`${name} is of ${recording.category}, which this service does not know`);
    this.chosenByHand = true;
    this.player?.pause();
    this.player = new Player(this.rest, recording, () => showPlayer(this.player), this.fail);
    this.look({ kind: "recording" });
    this.view.cloud.show(quantize(metres(recording.clouds[0])));
    this.view.frameOnce();
    this.begin(
      category,
      recording.init.map((part, i) => ({ ...part, name: category.parts[i] })),
      false,
    );
  }

  startPlacing(): void {
    const trackable = this.known.filter((each) => each.trackable);
    const category = trackable.find((each) => each.name === "mug") ?? trackable[0];
    if (category === undefined) throw new Error("this service has no model: export one, or set CAPTRA_MODELS_DIR");
    if (this.view.cloud.count === 0)
      throw new Error("there is no cloud yet: choose a session, a camera or a recording");
    this.begin(category, typicalParts(category, this.view.cloud.median(), this.view.up), false);
  }

  startReset(): void {
    const category = this.known.find((each) => each.name === this.summary?.category);
    if (this.result !== null && category !== undefined) this.begin(category, this.result.parts, true);
  }

  async confirm(): Promise<void> {
    const { category, parts } = this.placing;
    if (category === null) return;
    if (this.resetting) await this.reset(parts);
    else await this.open(category, parts);
    this.showAll();
  }

  async togglePlaying(): Promise<void> {
    const { player } = this;
    if (player === null) return;
    if (player.playing) return player.pause();
    if (player.session === null) {
      if (!this.placing.active) throw new Error("the session is closed: choose the recording again");
      await this.confirm();
    }
    if (player.ended) {
      await player.rewind();
      this.view.forgetTrail();
    }
    await player.play();
  }

  async closeSession(): Promise<void> {
    if (this.sessionId !== null) await this.rest.close(this.sessionId);
  }

  cancel(): void {
    if (!this.placing.active) return;
    this.placing.end();
    if (this.scene.kind === "recording") this.look(NOTHING);
    this.view.object.group.visible = this.result !== null;
    this.showAll();
  }

  centre(): void {
    const parts = this.placing.active ? this.placing.parts : this.result?.parts;
    if (parts === undefined) {
      this.view.frameAgain();
      this.view.frameOnce();
      return;
    }
    const extent = Math.max(...parts.flatMap((part) => part.size));
    this.view.lookAt(new Vector3(...parts[parts.length - 1].translation), CLOSE_UP * extent);
  }

  turnUp(): void {
    this.view.setUp(this.view.up === "camera" ? "robot" : "camera");
    byId("up").firstChild!.textContent = this.view.up === "camera" ? "Up −Y " : "Up +Z ";
  }

  step(by: number): void {
    const at = this.sessions.findIndex((each) => each.session_id === this.sessionId);
    const next = this.sessions[Math.min(this.sessions.length - 1, Math.max(0, at + by))];
    if (next !== undefined) this.choose({ kind: "session", id: next.session_id });
  }

  private get sessionId(): string | null {
    return this.scene.kind === "session" ? this.scene.id : null;
  }

  private get summary(): Summary | undefined {
    return this.sessions.find((each) => each.session_id === this.sessionId);
  }

  private get sceneName(): string {
    if (this.scene.kind === "session") return `session/${this.scene.id}`;
    return this.scene.kind === "preview" ? `preview/${this.scene.name}` : "";
  }

  private fetchRecording(name: string): void {
    this.attempt(async () => this.openRecording(name, await this.rest.recordingFile(name)));
  }

  private async open(category: Category, parts: Part[]): Promise<void> {
    const from = this.scene;
    const opened = await this.rest.open(category.name, parts);
    if (this.player !== null) this.player.session = opened.session_id;
    if (from.kind === "preview") {
      const { session_id: session, zenoh } = opened;
      this.stream.tell({ type: "feed", preview: from.name, session, secret: zenoh.secret });
    }
    this.look({ kind: "session", id: opened.session_id }, true);
  }

  private async reset(parts: Part[]): Promise<void> {
    if (this.sessionId === null) return;
    const fresh = await this.rest.reset(this.sessionId, parts);
    this.player?.restarted();
    this.placing.end();
    this.view.forgetTrail();
    this.take(fresh);
    this.showObject(fresh);
  }

  private begin(category: Category, parts: Part[], again: boolean): void {
    this.resetting = again;
    this.view.object.group.visible = false;
    this.placing.start(category, parts);
    this.showAll();
  }

  private choose(scene: Scene): void {
    this.chosenByHand = true;
    this.look(scene);
  }

  private look(scene: Scene, keepCloud = false): void {
    this.scene = scene;
    this.result = null;
    this.view.object.group.visible = false;
    this.view.forgetTrail();
    if (this.placing.active) this.placing.end();
    if (!keepCloud) {
      this.view.cloud.hide();
      this.view.frameAgain();
    }
    if (scene.kind !== "recording" && (this.player === null || this.player.session !== this.sessionId)) {
      this.player?.pause();
      this.player = null;
    }
    const { kind } = scene;
    this.stream.watch(kind === "session" ? { session: scene.id } : kind === "preview" ? { preview: scene.name } : {});
    this.charts.show(this.histories.of(this.sessionId));
    this.showAll();
    this.view.draw();
  }

  private survey(sessions: Summary[], previews: string[], time: number): void {
    for (const { session_id: id, processed, state, confidence, latency_ms } of sessions) {
      const before = this.sessions.find((each) => each.session_id === id)?.processed ?? processed;
      if (id !== this.sessionId && processed > before) this.histories.add(id, state, confidence, latency_ms);
    }
    this.histories.keep(new Set(sessions.map((each) => each.session_id)));
    Object.assign(this, { sessions, previews });
    this.sidebar.count(sessions, time);
    const newest = sessions.at(-1);
    if (this.scene.kind === "none" && !this.chosenByHand && newest !== undefined) {
      this.look({ kind: "session", id: newest.session_id });
    }
    this.showLists();
    this.showState();
  }

  private take(next: Result): void {
    if (next.session_id !== this.sessionId) return;
    this.result = next;
    if (next.seq !== null) {
      this.histories.add(next.session_id, next.state, next.confidence, next.timing_ms.total);
      this.charts.show(this.histories.of(next.session_id));
      this.view.follow(new Vector3(...next.parts[0].translation));
    }
    if (next.seq === null || this.view.cloud.count === 0) this.showObject(next);
    this.showState();
  }

  private showObject(shown: Result): void {
    this.view.object.group.visible = !this.placing.active;
    this.view.object.show(shown.parts, COLOURS[shown.state]);
    this.view.draw();
  }

  private showAll(): void {
    this.showLists();
    this.showState();
    this.showForm();
    showPlayer(this.player);
  }

  private showLists(): void {
    const { sessions, previews, recordings, known, scene } = this;
    this.sidebar.show({ sessions, previews, recordings, known, scene, played: this.player?.recording.name ?? null });
  }

  private showForm(): void {
    showForm(byId<HTMLFormElement>("placing"), this.placing, {
      known: this.known,
      fixed: this.resetting || this.scene.kind === "recording",
      confirm: this.resetting ? "Re-initialise" : "Open session",
      choose: (category) => {
        const centre = new Vector3(...this.placing.parts[0].translation);
        this.begin(category, typicalParts(category, centre, this.view.up), false);
      },
      cancel: () => this.cancel(),
    });
  }

  private showState(): void {
    const state = this.result?.state ?? this.summary?.state;
    const cloudless = this.view.cloud.count === 0;
    if (this.placing.active) {
      showTitle(this.resetting ? `New pose of the ${this.placing.category!.name}` : "A new session", "", undefined);
    } else {
      const confidence = this.result?.confidence ?? this.summary?.confidence ?? 0;
      const hint = state === "lost" ? "lost: re-initialise it (R)" : `${state} ${confidence.toFixed(2)}`;
      showTitle(this.sceneTitle, state === undefined ? "" : hint, state);
    }
    byId("reset").hidden = byId("close").hidden = this.sessionId === null || this.placing.active;
    byId("place").hidden = this.placing.active || cloudless;
    byId("reset").classList.toggle("primary", state === "lost");
    showEmpty(cloudless ? this.whatToDo : null);
    showParts(this.placing.active ? null : this.result);
  }

  private get sceneTitle(): string {
    const { scene } = this;
    if (scene.kind === "preview") return scene.name;
    return scene.kind === "recording" ? (this.player?.recording.category ?? "") : (this.summary?.category ?? "");
  }

  private get whatToDo(): { title: string; text: string } | null {
    if (this.scene.kind === "session") {
      const text = "The session is open. Put clouds on its key, or POST them to its frames.";
      return this.result?.seq == null ? { title: "Waiting for the first cloud", text } : null;
    }
    if (this.scene.kind !== "none") return null;
    const text =
      this.sessions.length > 0
        ? "Choose a session on the left."
        : "Play a recording from the list on the left, or drop one anywhere.";
    return { title: "Nothing to look at yet", text };
  }
}
