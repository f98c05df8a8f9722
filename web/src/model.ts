// What the page knows of the service, and what of that it looks at.
import { NOTHING } from "./types";
import type { Category, Listed, Result, Scene, Summary, Target } from "./types";

export class Model {
  scene: Scene = NOTHING;
  sessions: Summary[] = [];
  previews: string[] = [];
  known: Category[] = [];
  recordings: Listed[] = [];
  result: Result | null = null; // the newest of the session that is looked at

  get sessionId(): string | null {
    return this.scene.kind === "session" ? this.scene.id : null;
  }

  get summary(): Summary | undefined {
    return this.sessions.find((each) => each.session_id === this.sessionId);
  }

  // As the stream names it in clouds.
  get sceneName(): string {
    if (this.scene.kind === "session") return `session/${this.scene.id}`;
    return this.scene.kind === "preview" ? `preview/${this.scene.name}` : "";
  }

  get target(): Target {
    if (this.scene.kind === "session") return { session: this.scene.id };
    return this.scene.kind === "preview" ? { preview: this.scene.name } : {};
  }

  category(name: string | undefined): Category | undefined {
    return this.known.find((each) => each.name === name);
  }

  // The session so many places below; the last one where there are no more.
  neighbour(by: number): Summary | undefined {
    const at = this.sessions.findIndex((each) => each.session_id === this.sessionId);
    return this.sessions[Math.min(this.sessions.length - 1, Math.max(0, at + by))];
  }
}
