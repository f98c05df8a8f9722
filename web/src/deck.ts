// The recording that is played, if any, and the bar that says how far it is.
import { Player } from "./player";
import { showPlayer } from "./player_bar";
import type { Recording } from "./recording";
import type { Rest } from "./rest";

export class Deck {
  player: Player | null = null;

  constructor(
    private rest: Rest,
    private fail: (error: unknown) => void,
  ) {}

  get recording(): Recording | null {
    return this.player?.recording ?? null;
  }

  // From the beginning, in a session that is still to be opened.
  load(recording: Recording): void {
    this.player?.pause();
    this.player = new Player(this.rest, recording, () => this.show(), this.fail);
  }

  playInto(session: string): void {
    if (this.player !== null) this.player.session = session;
  }

  // What is looked at now is not what this one plays into.
  leaveUnless(session: string | null): void {
    if (this.player !== null && this.player.session === session) return;
    this.player?.pause();
    this.player = null;
  }

  show(): void {
    showPlayer(this.player);
  }
}
