// The left side: sessions, cameras without a session, recordings.
import { CardList, type Card } from "./cards";
import { byId, element, words } from "./dom";
import type { Model } from "./model";
import type { Listed, Scene, Summary } from "./types";

const RATE_SECONDS = 0.9;

export interface Choices {
  look(scene: Scene): void;
  openRecording(listed: Listed): void;
}

// What a name tells: those that ship are category__source__object__how, those of sessions category_id.
function told(name: string): { category: string; about: string } {
  const [, category, session] = /^(.+)_([0-9a-f]{16}(?:-\d+)?)$/.exec(name) ?? [];
  if (category !== undefined) return { category, about: `session ${session}` };
  const [first, , ...about] = name.split("__");
  return { category: first, about: about.join(", ").replaceAll(/[-_]/g, " ") || name };
}

export class Sidebar {
  private rates = new Map<string, { processed: number; time: number; fps: number }>();
  private sessions = new CardList(byId("sessions"), "session", [
    "None yet. Play a recording, place a box on a camera's cloud, or let a client POST /v1/sessions.",
  ]);
  private previews = new CardList(byId("previews"), "preview", [
    "Clouds put on ",
    element("code", { textContent: "captra/default/previews/NAME" }),
    " show up here.",
  ]);
  private recordings = new CardList(byId("recordings"), "recording", []);

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

  // `played` names a recording.
  show({ sessions, previews, recordings, known, scene }: Model, played: string | null): void {
    const untrackable = new Set(known.filter((each) => !each.trackable).map((each) => each.name));
    this.sessions.show(sessions.map((each) => this.sessionCard(each, scene)));
    this.previews.show(previews.map((name) => this.previewCard(name, scene)));
    this.recordings.show(recordings.map((each) => this.recordingCard(each, untrackable, played)));
  }

  private sessionCard(summary: Summary, scene: Scene): Card {
    const { session_id: id, state, confidence, latency_ms, rejected } = summary;
    const fps = this.rates.get(id)?.fps ?? 0;
    const refused = rejected > 0 ? ` · ${rejected} rejected` : "";
    return {
      key: id,
      title: words(summary.category),
      side: `${state} ${confidence.toFixed(2)}`,
      detail: `${fps.toFixed(0)} fps · ${latency_ms.toFixed(0)} ms${refused}`,
      on: scene.kind === "session" && scene.id === id,
      state,
      share: confidence,
      act: () => this.choices.look({ kind: "session", id }),
    };
  }

  private previewCard(name: string, scene: Scene): Card {
    return {
      key: name,
      title: name,
      detail: "clouds without a session",
      on: scene.kind === "preview" && scene.name === name,
      act: () => this.choices.look({ kind: "preview", name }),
    };
  }

  private recordingCard(listed: Listed, untrackable: Set<string>, played: string | null): Card {
    const { name } = listed,
      { category, about } = told(name.replace(/\.mcap$/, "")),
      disabled = untrackable.has(category);
    return {
      key: name,
      title: words(category),
      detail: disabled ? "no model of it here" : about,
      on: played === name,
      disabled,
      act: () => this.choices.openRecording(listed),
    };
  }
}
