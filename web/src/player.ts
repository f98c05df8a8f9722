// Plays a recording into a session at the pace of its stamps, every cloud in turn; slower where the service is.
import { Refusal, type Rest } from "./rest";
import type { Recording } from "./recording";
import type { Part } from "./types";

export class Player {
  playing = false;
  frame = 0;
  session: string | null = null;
  private seq = 0;

  constructor(
    private rest: Rest,
    readonly recording: Recording,
    private changed: () => void,
    private failed: (error: unknown) => void,
  ) {}

  get ended(): boolean {
    return this.frame >= this.recording.frames.length - 1;
  }

  async play(): Promise<void> {
    const { frames } = this.recording;
    if (this.playing) return;
    this.playing = true;
    while (this.playing && this.session !== null) {
      this.changed();
      const sent = performance.now();
      if (!(await this.send(this.session)) || this.ended) break;
      this.frame++;
      const interval = Number(frames[this.frame].stamp - frames[this.frame - 1].stamp) / 1e6;
      await new Promise((done) => setTimeout(done, Math.max(0, interval - (performance.now() - sent))));
    }
    this.pause();
  }

  pause(): void {
    this.playing = false;
    this.changed();
  }

  // To the beginning, from where the object was then.
  async rewind(): Promise<void> {
    if (this.session === null) return;
    await this.resetTo(this.session, this.recording.init);
    this.frame = 0;
  }

  // The session was re-initialised: it counts from zero again.
  restarted(): void {
    this.seq = 0;
  }

  private async resetTo(session: string, parts: Part[]): Promise<void> {
    await this.rest.reset(session, parts);
    this.restarted();
  }

  // Whether it goes on.
  private async send(session: string): Promise<boolean> {
    const frame = this.recording.frames[this.frame];
    try {
      if (frame.reset !== null) await this.resetTo(session, frame.reset);
      await this.rest.postFrame(session, this.seq++, frame);
    } catch (error) {
      const reason = error instanceof Refusal ? error.reason : undefined;
      if (reason === "no-points-near-object") return true;
      if (reason === "unknown-session") this.session = null;
      this.failed(error);
      return false;
    }
    return true;
  }
}
