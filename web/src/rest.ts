// The service's REST API; refusals become errors that say what to do.
import type { Category, Part, Result } from "./types";

async function call(method: string, path: string, body?: BodyInit, type = "application/json"): Promise<Response> {
  const answer = await fetch(path, { method, body, headers: body === undefined ? {} : { "Content-Type": type } });
  if (!answer.ok) {
    const problem = await answer.json().catch(() => ({}));
    throw Object.assign(new Error(problem.detail ?? `${method} ${path}: ${answer.status}`), { reason: problem.reason });
  }
  return answer;
}

const poseOf = (parts: Part[]) => parts.map(({ translation, quat_xyzw, size }) => ({ rotation: { quat_xyzw }, translation, size }));

export const categories = async (): Promise<Category[]> => (await (await call("GET", "/v1/categories")).json()).categories;
export const recordings = async (): Promise<{ name: string; bytes: number }[]> => (await call("GET", "/viewer/recordings")).json();
export const recordingFile = async (name: string): Promise<ArrayBuffer> => (await call("GET", `/viewer/recordings/${encodeURIComponent(name)}.npz`)).arrayBuffer();
export const open = async (category: string, parts: Part[]): Promise<{ session_id: string }> =>
  (await call("POST", "/v1/sessions", JSON.stringify({ category, parts: poseOf(parts) }))).json();
export const reset = async (id: string, parts: Part[]): Promise<Result> => (await call("PUT", `/v1/sessions/${id}/pose`, JSON.stringify({ parts: poseOf(parts) }))).json();
export const close = (id: string): Promise<Response> => call("DELETE", `/v1/sessions/${id}`);
export const postFrame = async (id: string, seq: number, stamp: bigint, points: Int16Array<ArrayBuffer>): Promise<Result> =>
  (await call("POST", `/v1/sessions/${id}/frames?seq=${seq}&stamp_ns=${stamp}`, points, "application/vnd.captra.cloud.i16")).json();
