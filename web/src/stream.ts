// The one websocket: says what is looked at, and comes back by itself when the service was away.
import type { CloudMessage, Message } from "./types";

const RETRY_MS = 1000;

export class Stream {
  private socket: WebSocket | null = null;
  private looking: object = { type: "watch" };

  constructor(private onMessage: (m: Message) => void, private onCloud: (m: CloudMessage) => void, private onLink: (live: boolean) => void) {
    this.connect();
    document.addEventListener("visibilitychange", () => this.tell(document.hidden ? { type: "watch" } : this.looking));
  }

  watch(target: { session?: string; preview?: string }): void {
    this.looking = { type: "watch", ...target };
    this.tell(this.looking);
  }

  tell(message: object): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(message));
  }

  private connect(): void {
    const socket = new WebSocket(`${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/viewer/stream`);
    socket.binaryType = "arraybuffer";
    socket.onopen = () => { this.onLink(true); this.tell(this.looking); };
    socket.onmessage = ({ data }) => (typeof data === "string" ? this.onMessage(JSON.parse(data)) : this.onCloud(decode(data)));
    socket.onclose = () => { this.onLink(false); setTimeout(() => this.connect(), RETRY_MS); };
    this.socket = socket;
  }
}

function decode(buffer: ArrayBuffer): CloudMessage {
  const length = new DataView(buffer).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
  return { ...header, quantized: new Uint16Array(buffer, 4 + length) };
}
