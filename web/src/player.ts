// Plays a recording into a session at the pace of its stamps, every cloud in turn; slower where the service is.
import * as rest from "./rest";
import type { Recording } from "./recording";

export class Player {
  playing = false;
  frame = 0;
  private seq = 0;

  constructor(readonly recording: Recording, public session: string | null, private changed: () => void, private failed: (error: Error) => void) {}

  get ended(): boolean { return this.frame >= this.recording.clouds.length - 1; }

  async play(): Promise<void> {
    const { stamps, clouds } = this.recording;
    if (this.playing || this.session === null) return;
    this.playing = true;
    while (this.playing && this.frame < clouds.length && this.session !== null) {
      const session: string = this.session;
      this.changed();
      const sent = performance.now();
      try {
        await rest.postFrame(session, this.seq++, stamps[this.frame], clouds[this.frame]);
      } catch (error) {
        if ((error as { reason?: string }).reason === "unknown-session") this.session = null;
        if ((error as { reason?: string }).reason !== "no-points-near-object") { this.failed(error as Error); break; }
      }
      if (this.ended) break;
      this.frame++;
      const interval = Number(stamps[this.frame] - stamps[this.frame - 1]) / 1e6;
      await new Promise((done) => setTimeout(done, Math.max(0, interval - (performance.now() - sent))));
    }
    this.playing = false;
    this.changed();
  }

  pause(): void { this.playing = false; this.changed(); }
  restarted(): void { this.seq = 0; }
}
