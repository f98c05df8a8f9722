// The service's REST API; refusals become errors that say what to do.
import type { Keyring } from "./keyring";
import type { Frame } from "./recording";
import type { Category, Listed, Opened, Part, Result } from "./types";

const JSON_TYPE = "application/json";
const BOX_BYTES = 8;
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

function boxOf(region: Uint8Array<ArrayBuffer>): string {
  const edges = new DataView(region.buffer);
  return `&box=${[0, 2, 4, 6].map((at) => edges.getUint16(at, true)).join()}`;
}

function formOf(payload: Uint8Array<ArrayBuffer>, encoding: string, mask: Uint8Array<ArrayBuffer>): FormData {
  const form = new FormData();
  form.append("cloud", new Blob([payload], { type: encoding.split(";")[0] }), "cloud");
  form.append("mask", new Blob([mask], { type: "image/png" }), "mask.png");
  return form;
}

export class Rest {
  constructor(private keys: Keyring) {}

  async categories(): Promise<Category[]> {
    return (await (await this.call("GET", "/v1/categories")).json()).categories;
  }

  async recordings(): Promise<Listed[]> {
    return (await this.call("GET", "/viewer/recordings")).json();
  }

  async file({ path }: Listed): Promise<ArrayBuffer> {
    return (await this.call("GET", path)).arrayBuffer();
  }

  async open(category: string, parts: Part[], options: object): Promise<Opened> {
    const body = JSON.stringify({ ...options, category, parts: poseOf(parts) });
    return (await this.call("POST", "/v1/sessions", body)).json();
  }

  async reset(id: string, parts: Part[]): Promise<Result> {
    return (await this.call("PUT", `/v1/sessions/${id}/pose`, JSON.stringify({ parts: poseOf(parts) }))).json();
  }

  async close(id: string): Promise<void> {
    await this.call("DELETE", `/v1/sessions/${id}`);
  }

  async postFrame(id: string, seq: number, { stamp, encoding, payload, region }: Frame): Promise<void> {
    const path = `/v1/sessions/${id}/frames?seq=${seq}&stamp_ns=${stamp}`;
    if (region === null) await this.call("POST", path, payload(), encoding);
    else if (region.length === BOX_BYTES) await this.call("POST", path + boxOf(region), payload(), encoding);
    else await this.call("POST", path, formOf(payload(), encoding, region), null);
  }

  // A form says itself of what type it is.
  private async call(
    method: string,
    path: string,
    body?: BodyInit,
    type: string | null = JSON_TYPE,
  ): Promise<Response> {
    const headers =
      body === undefined || type === null ? this.keys.headers : { ...this.keys.headers, "Content-Type": type };
    const answer = await fetch(path, { method, body, headers });
    if (answer.ok) return answer;
    const problem = await answer.json().catch(() => ({}));
    const refusal = new Refusal(problem.detail ?? `${method} ${path}: ${answer.status}`, problem.reason);
    if (answer.status !== UNAUTHORIZED) throw refusal;
    await this.keys.ask(refusal.message);
    return this.call(method, path, body, type);
  }
}
