// The one websocket: says what is looked at, and comes back by itself when the service was away.
import type { Keyring } from "./keyring";
import type { CloudMessage, Message, Target } from "./types";

const RETRY_MS = 1000;

export interface Listener {
  onMessage(message: Message): void;
  onCloud(message: CloudMessage): void;
  onLink(live: boolean): void;
  // Rejects while the service does not answer; resolves once it lets the page in.
  admitted(): Promise<void>;
}

export class Stream {
  private socket: WebSocket | null = null;
  private looking: object = { type: "watch" };

  constructor(
    private keys: Keyring,
    private listener: Listener,
  ) {}

  start(): void {
    void this.connect();
    document.addEventListener("visibilitychange", () => this.tell(document.hidden ? { type: "watch" } : this.looking));
  }

  watch(target: Target): void {
    this.looking = { type: "watch", ...target };
    this.tell(this.looking);
  }

  tell(message: object): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(message));
  }

  private async connect(): Promise<void> {
    try {
      await this.listener.admitted();
    } catch {
      return this.retry();
    }
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const socket = new WebSocket(`${scheme}://${location.host}/viewer/stream${this.keys.query}`);
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      this.listener.onLink(true);
      this.tell(this.looking);
    };
    socket.onmessage = ({ data }) =>
      typeof data === "string" ? this.listener.onMessage(JSON.parse(data)) : this.listener.onCloud(decode(data));
    socket.onclose = () => this.retry();
    this.socket = socket;
  }

  private retry(): void {
    this.listener.onLink(false);
    setTimeout(() => void this.connect(), RETRY_MS);
  }
}

// A little-endian length, a JSON header, 16-bit coordinates.
function decode(buffer: ArrayBuffer): CloudMessage {
  const length = new DataView(buffer).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
  return { ...header, quantized: new Uint16Array(buffer, 4 + length) };
}
