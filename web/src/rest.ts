// The service's REST API; refusals become errors that say what to do.
import type { Keyring } from "./keyring";
import type { Category, Opened, Part, Result } from "./types";

const JSON_TYPE = "application/json";
const CLOUD_TYPE = "application/vnd.captra.cloud.i16";
const UNAUTHORIZED = 401;

export class Refusal extends Error {
  constructor(
    detail: string,
    readonly reason: string | undefined,
  ) {
    super(detail);
  }
}

const poseOf = (parts: Part[]) =>
  parts.map(({ translation, quat_xyzw, size }) => ({ rotation: { quat_xyzw }, translation, size }));

export class Rest {
  constructor(private keys: Keyring) {}

  async categories(): Promise<Category[]> {
    return (await (await this.call("GET", "/v1/categories")).json()).categories;
  }

  async recordings(): Promise<{ name: string }[]> {
    return (await this.call("GET", "/viewer/recordings")).json();
  }

  async recordingFile(name: string): Promise<ArrayBuffer> {
    return (await this.call("GET", `/viewer/recordings/${encodeURIComponent(name)}.npz`)).arrayBuffer();
  }

  async open(category: string, parts: Part[]): Promise<Opened> {
    return (await this.call("POST", "/v1/sessions", JSON.stringify({ category, parts: poseOf(parts) }))).json();
  }

  async reset(id: string, parts: Part[]): Promise<Result> {
    return (await this.call("PUT", `/v1/sessions/${id}/pose`, JSON.stringify({ parts: poseOf(parts) }))).json();
  }

  async close(id: string): Promise<void> {
    await this.call("DELETE", `/v1/sessions/${id}`);
  }

  async postFrame(id: string, seq: number, stamp: bigint, points: Int16Array<ArrayBuffer>): Promise<void> {
    await this.call("POST", `/v1/sessions/${id}/frames?seq=${seq}&stamp_ns=${stamp}`, points, CLOUD_TYPE);
  }

  private async call(method: string, path: string, body?: BodyInit, type = JSON_TYPE): Promise<Response> {
    const headers = body === undefined ? this.keys.headers : { ...this.keys.headers, "Content-Type": type };
    const answer = await fetch(path, { method, body, headers });
    if (answer.ok) return answer;
    const problem = await answer.json().catch(() => ({}));
    const refusal = new Refusal(problem.detail ?? `${method} ${path}: ${answer.status}`, problem.reason);
    if (answer.status !== UNAUTHORIZED) throw refusal;
    await this.keys.ask(refusal.message);
    return this.call(method, path, body, type);
  }
}
