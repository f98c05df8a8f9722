// The left side: sessions, cameras without a session, recordings.
import { byId, element, words } from "./dom";
import type { Category, Scene, Summary } from "./types";

const RATE_SECONDS = 0.9;

export interface Lists {
  sessions: Summary[];
  previews: string[];
  recordings: string[];
  known: Category[];
  scene: Scene;
  played: string | null;
}

export interface Choices {
  look(scene: Scene): void;
  openRecording(name: string): void;
}

interface Card {
  title: string;
  side?: string;
  detail: string;
  on: boolean;
  act: () => void;
}

export class Sidebar {
  private rates = new Map<string, { processed: number; time: number; fps: number }>();
  private shown = "";

  constructor(private choices: Choices) {}

  // Frames a second, from the counters of two overviews.
  count(sessions: Summary[], time: number): void {
    for (const { session_id, processed } of sessions) {
      const last = this.rates.get(session_id);
      if (last !== undefined && time - last.time < RATE_SECONDS) continue;
      const fps = last === undefined ? 0 : (processed - last.processed) / (time - last.time);
      this.rates.set(session_id, { processed, time, fps });
    }
  }

  show(lists: Lists): void {
    const { sessions, previews, recordings, known, scene, played } = lists;
    const now = JSON.stringify([lists, sessions.map((each) => this.fps(each))]);
    if (now === this.shown) return; // what is under a finger is not replaced for nothing
    this.shown = now;
    const trackable = new Set(known.filter((each) => each.trackable).map((each) => each.name));
    fill(
      "sessions",
      sessions.map((each) => this.sessionCard(each, scene)),
      ["None yet. Play a recording, place a box on a camera's cloud, or let a client POST /v1/sessions."],
    );
    fill(
      "previews",
      previews.map((name) => this.previewCard(name, scene)),
      ["Clouds put on ", element("code", { textContent: "captra/default/previews/NAME" }), " show up here."],
    );
    fill(
      "recordings",
      recordings.map((name) => this.recordingCard(name, trackable, played)),
      [],
    );
  }

  private fps(summary: Summary): number {
    return this.rates.get(summary.session_id)?.fps ?? 0;
  }

  private sessionCard(summary: Summary, scene: Scene): HTMLElement {
    const { session_id: id, state, confidence, latency_ms, rejected } = summary;
    const made = card({
      title: words(summary.category),
      side: `${state} ${confidence.toFixed(2)}`,
      detail: `${this.fps(summary).toFixed(0)} fps · ${latency_ms.toFixed(0)} ms${rejected > 0 ? ` · ${rejected} rejected` : ""}`,
      on: scene.kind === "session" && scene.id === id,
      act: () => this.choices.look({ kind: "session", id }),
    });
    made.dataset.session = id;
    made.dataset.state = state;
    const bar = element("i");
    bar.style.width = `${100 * confidence}%`;
    made.append(element("span", { className: "bar" }, bar));
    return made;
  }

  private previewCard(name: string, scene: Scene): HTMLElement {
    const made = card({
      title: name,
      detail: "clouds without a session",
      on: scene.kind === "preview" && scene.name === name,
      act: () => this.choices.look({ kind: "preview", name }),
    });
    made.dataset.preview = name;
    return made;
  }

  // Recordings are named category__source__object__how.
  private recordingCard(name: string, trackable: Set<string>, played: string | null): HTMLElement {
    const [category, , ...about] = name.split("__");
    const tracked = trackable.has(category);
    const made = card({
      title: words(category),
      detail: tracked ? about.join(", ").replaceAll(/[-_]/g, " ") || name : "no model of it here",
      on: played === name,
      act: () => this.choices.openRecording(name),
    });
    made.disabled = !tracked;
    made.dataset.recording = name;
    return made;
  }
}

function fill(id: string, cards: HTMLElement[], otherwise: (Node | string)[]): void {
  byId(id).replaceChildren(...(cards.length > 0 ? cards : [element("p", {}, ...otherwise)]));
}

function card({ title, side = "", detail, on, act }: Card): HTMLButtonElement {
  return element(
    "button",
    { className: on ? "card on" : "card", onclick: act },
    element("span", { className: "dot" }),
    element("strong", { textContent: title, title }),
    element("em", { textContent: side }),
    element("small", { textContent: detail }),
  );
}
