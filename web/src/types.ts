// What goes over the wire, in the service's own words: metres, radians, milliseconds; frame of the clouds.
export type Vec3 = [number, number, number];
export type Vec4 = [number, number, number, number];
export type State = "tracking" | "uncertain" | "lost" | "recovering";

export interface Part {
  name: string;
  translation: Vec3;
  quat_xyzw: Vec4;
  size: Vec3;
}

export interface Joint {
  name: string;
  kind: "revolute" | "prismatic";
  value: number;
}

export interface Result {
  session_id: string;
  seq: number | null;
  state: State;
  confidence: number;
  parts: Part[];
  joints: Joint[];
  timing_ms: { total: number };
}

export interface Summary {
  session_id: string;
  category: string;
  state: State;
  confidence: number;
  latency_ms: number;
  processed: number;
  dropped: number;
  rejected: number;
}

export interface Category {
  name: string;
  parts: string[];
  root: string;
  surroundings: boolean;
  trackable: boolean;
}

// A recording that the service offers to play.
export interface Listed {
  name: string;
  path: string;
}

export interface Opened {
  session_id: string;
  zenoh: { secret: string | null };
}

export interface Cloud {
  quantized: Uint16Array;
  origin: Vec3;
  step: Vec3;
  count: number;
  of: number;
}

export type CloudMessage = Cloud & { type: "cloud"; scene: string; result: Result | null };

export interface Overview {
  type: "overview";
  time_s: number;
  sessions: Summary[];
  previews: string[];
  recordings_changes: number;
}

export type Message =
  | Overview
  | { type: "result"; result: Result }
  | { type: "event"; event: { kind: string; session_id: string; reason: string | null; detail: string | null } }
  | { type: "refused"; detail: string };

// What the websocket is told to show.
export type Target = { session?: string; preview?: string };

// What the page looks at.
export type Scene =
  { kind: "none" } | { kind: "session"; id: string } | { kind: "preview"; name: string } | { kind: "recording" };

export const NOTHING: Scene = { kind: "none" };

export const COLOURS: Record<State, string> = {
  tracking: "#3ecf8e",
  uncertain: "#f2b84b",
  lost: "#f0616d",
  recovering: "#f2b84b",
};
export const PLACING = "#c9b6ff";
