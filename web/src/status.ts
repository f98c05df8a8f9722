// What is said of the scene: its name and state, the buttons that make sense, and what to do when there is nothing.
import { showEmpty, showParts, showTitle } from "./caption";
import { byId } from "./dom";
import type { Model } from "./model";
import type { Placing } from "./placing";

export interface Circumstances {
  placing: Placing;
  resetting: boolean;
  cloudless: boolean;
  played: string | null; // category of the recording that is played
}

export function showStatus(model: Model, { placing, resetting, cloudless, played }: Circumstances): void {
  const state = model.result?.state ?? model.summary?.state;
  if (placing.active) {
    showTitle(resetting ? `New pose of the ${placing.category!.name}` : "A new session", "", undefined);
  } else {
    const confidence = model.result?.confidence ?? model.summary?.confidence ?? 0;
    const hint = state === "lost" ? "lost: re-initialise it (R)" : `${state} ${confidence.toFixed(2)}`;
    showTitle(nameOf(model, played), state === undefined ? "" : hint, state);
  }
  byId("reset").hidden = byId("close").hidden = model.sessionId === null || placing.active;
  byId("place").hidden = placing.active || cloudless;
  byId("reset").classList.toggle("primary", state === "lost");
  showEmpty(cloudless ? whatToDo(model) : null);
  showParts(placing.active ? null : model.result);
}

function nameOf({ scene, summary }: Model, played: string | null): string {
  if (scene.kind === "preview") return scene.name;
  return scene.kind === "recording" ? (played ?? "") : (summary?.category ?? "");
}

function whatToDo({ scene, result, sessions }: Model): { title: string; text: string } | null {
  if (scene.kind === "session") {
    const text = "The session is open. Put clouds on its key, or POST them to its frames.";
    return result?.seq == null ? { title: "Waiting for the first cloud", text } : null;
  }
  if (scene.kind !== "none") return null;
  const text =
    sessions.length > 0
      ? "Choose a session on the left."
      : "Play a recording from the list on the left, or drop one anywhere.";
  return { title: "Nothing to look at yet", text };
}
