// A recording that can be played, whichever file it came from.
import { readMcap } from "./mcap";
import { readNpz } from "./npz";
import type { Part } from "./types";

export interface Frame {
  stamp: bigint;
  encoding: string;
  payload(): Uint8Array<ArrayBuffer>;
  region: Uint8Array<ArrayBuffer> | null; // a mask (PNG) or a box (8 bytes)
  reset: Part[] | null; // where the track was started again before it
}

export interface Recording {
  name: string;
  category: string;
  options: object; // of its session, as POST /v1/sessions takes them
  init: Part[];
  frames: Frame[];
  points: Float32Array | null; // of the first frame, metres, where the file shows them
}

const MAGIC: [string, (name: string, file: ArrayBuffer) => Recording | Promise<Recording>][] = [
  ["\x89MCAP0\r\n", readMcap],
  ["PK", readNpz],
];

export async function readRecording(name: string, file: ArrayBuffer): Promise<Recording> {
  const begin = String.fromCharCode(...new Uint8Array(file, 0, Math.min(8, file.byteLength)));
  const read = MAGIC.find(([magic]) => begin.startsWith(magic))?.[1];
  if (read === undefined) throw new Error(`${name} is no recording: choose an .mcap or .npz file that captra wrote`);
  return read(name, file);
}
