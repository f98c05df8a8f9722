// What the page looks at and what can be done with it.
import { Vector3 } from "three";
import { Charts } from "./charts";
import { quantize } from "./cloud";
import { Deck } from "./deck";
import { byId } from "./dom";
import { Histories } from "./history";
import type { Keyring } from "./keyring";
import { Model } from "./model";
import { Placing, typicalParts } from "./placing";
import { showForm } from "./placing_form";
import { readRecording } from "./recording";
import type { Rest } from "./rest";
import { View } from "./scene";
import { Sidebar } from "./sidebar";
import { showStatus } from "./status";
import { Stream, type Listener } from "./stream";
import { COLOURS, NOTHING } from "./types";
import type { Category, CloudMessage, Message, Overview, Part, Result, Scene } from "./types";

const TOAST_MS = 6000;
const CLOSE_UP = 3.2;

export class App implements Listener {
  readonly view = new View(byId<HTMLCanvasElement>("canvas"), byId("labels"));
  readonly placing = new Placing(this.view, byId("canvas"), () => this.showForm());
  readonly deck: Deck;
  private model = new Model();
  private charts = new Charts(byId);
  private histories = new Histories();
  private sidebar = new Sidebar({
    look: (scene) => this.choose(scene),
    openRecording: (listed) => this.attempt(async () => this.openRecording(listed.name, await this.rest.file(listed))),
  });
  private stream: Stream;
  private resetting = false;
  private chosenByHand = false;
  private recordingsChanges: number | null = null;

  constructor(
    private rest: Rest,
    keys: Keyring,
  ) {
    this.deck = new Deck(rest, this.fail);
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
    Object.assign(this.model, { known, recordings });
    this.showLists();
  }

  onLink(live: boolean): void {
    this.recordingsChanges = null; // a service that was started again counts anew
    byId("link").className = live ? "live" : "";
    byId("link").textContent = live ? "live" : "no connection";
  }

  onMessage(message: Message): void {
    switch (message.type) {
      case "overview":
        return this.survey(message);
      case "result":
        return this.take(message.result);
      case "refused":
        return this.fail(message.detail);
      case "event": {
        const { kind, session_id, reason, detail } = message.event;
        if (kind !== "closing" || session_id !== this.model.sessionId) return;
        this.fail(`The session is closed: ${detail ?? reason}`);
        this.look(NOTHING);
      }
    }
  }

  onCloud(message: CloudMessage): void {
    if (message.scene !== this.model.sceneName) return;
    this.view.cloud.show(message);
    if (message.result !== null) this.showObject(message.result);
    this.view.frameOnce();
    this.view.draw();
    this.showState();
  }

  async openRecording(name: string, file: ArrayBuffer): Promise<void> {
    const recording = await readRecording(name, file);
    if (this.model.known.length === 0) await this.admitted();
    const category = this.model.category(recording.category);
    if (category === undefined)
      throw new Error(`${name} is of ${recording.category}, which this service does not know`);
    this.chosenByHand = true;
    this.deck.load(recording);
    this.look({ kind: "recording" });
    if (recording.points !== null && recording.points.length > 0) {
      this.view.cloud.show(quantize(recording.points));
      this.view.frameOnce();
    }
    this.begin(
      category,
      recording.init.map((part, i) => ({ ...part, name: category.parts[i] })),
      false,
    );
  }

  startPlacing(): void {
    const trackable = this.model.known.filter((each) => each.trackable);
    const category = trackable.find((each) => each.name === "mug") ?? trackable[0];
    if (category === undefined) throw new Error("this service has no model: export one, or set CAPTRA_MODELS_DIR");
    if (this.view.cloud.count === 0)
      throw new Error("there is no cloud yet: choose a session, a camera or a recording");
    this.begin(category, typicalParts(category, this.view.cloud.median(), this.view.up), false);
  }

  startReset(): void {
    const { result, summary } = this.model,
      category = this.model.category(summary?.category);
    if (result !== null && category !== undefined) this.begin(category, result.parts, true);
  }

  async confirm(): Promise<void> {
    const { category, parts } = this.placing;
    if (category === null) return;
    if (this.resetting) await this.reset(parts);
    else await this.open(category, parts);
    this.showAll();
  }

  async togglePlaying(): Promise<void> {
    const { player } = this.deck;
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
    const { sessionId } = this.model;
    if (sessionId !== null) await this.rest.close(sessionId);
  }

  cancel(): void {
    if (!this.placing.active) return;
    this.placing.end();
    if (this.model.scene.kind === "recording") this.look(NOTHING);
    this.view.object.group.visible = this.model.result !== null;
    this.showAll();
  }

  centre(): void {
    const parts = this.placing.active ? this.placing.parts : this.model.result?.parts;
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
    const next = this.model.neighbour(by);
    if (next !== undefined) this.choose({ kind: "session", id: next.session_id });
  }

  private async open(category: Category, parts: Part[]): Promise<void> {
    const from = this.model.scene;
    const opened = await this.rest.open(category.name, parts, this.deck.recording?.options ?? {});
    this.deck.playInto(opened.session_id);
    if (from.kind === "preview") {
      const { session_id: session, zenoh } = opened;
      this.stream.tell({ type: "feed", preview: from.name, session, secret: zenoh.secret });
    }
    this.look({ kind: "session", id: opened.session_id }, true);
  }

  private async reset(parts: Part[]): Promise<void> {
    const { sessionId } = this.model;
    if (sessionId === null) return;
    const fresh = await this.rest.reset(sessionId, parts);
    this.deck.player?.restarted();
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
    Object.assign(this.model, { scene, result: null });
    this.view.object.group.visible = false;
    this.view.forgetTrail();
    if (this.placing.active) this.placing.end();
    if (!keepCloud) {
      this.view.cloud.hide();
      this.view.frameAgain();
    }
    if (scene.kind !== "recording") this.deck.leaveUnless(this.model.sessionId);
    this.stream.watch(this.model.target);
    this.charts.show(this.histories.of(this.model.sessionId));
    this.showAll();
    this.view.draw();
  }

  private survey({ sessions, previews, time_s, recordings_changes }: Overview): void {
    for (const { session_id: id, processed, state, confidence, latency_ms } of sessions) {
      const before = this.model.sessions.find((each) => each.session_id === id)?.processed ?? processed;
      if (id !== this.model.sessionId && processed > before) this.histories.add(id, state, confidence, latency_ms);
    }
    this.histories.keep(new Set(sessions.map((each) => each.session_id)));
    if (this.recordingsChanges !== recordings_changes) {
      this.recordingsChanges = recordings_changes;
      this.attempt(() => this.admitted());
    }
    Object.assign(this.model, { sessions, previews });
    this.sidebar.count(sessions, time_s);
    const newest = sessions.at(-1);
    if (this.model.scene.kind === "none" && !this.chosenByHand && newest !== undefined) {
      this.look({ kind: "session", id: newest.session_id });
    }
    this.showLists();
    this.showState();
  }

  private take(next: Result): void {
    if (next.session_id !== this.model.sessionId) return;
    this.model.result = next;
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
    this.deck.show();
  }

  private showLists(): void {
    this.sidebar.show(this.model, this.deck.recording?.name ?? null);
  }

  private showForm(): void {
    showForm(byId<HTMLFormElement>("placing"), this.placing, {
      known: this.model.known,
      fixed: this.resetting || this.model.scene.kind === "recording",
      confirm: this.resetting ? "Re-initialise" : "Open session",
      choose: (category) => {
        const centre = new Vector3(...this.placing.parts[0].translation);
        this.begin(category, typicalParts(category, centre, this.view.up), false);
      },
      cancel: () => this.cancel(),
    });
  }

  private showState(): void {
    const { placing, resetting } = this,
      played = this.deck.recording?.category ?? null;
    showStatus(this.model, { placing, resetting, cloudless: this.view.cloud.count === 0, played });
  }
}
