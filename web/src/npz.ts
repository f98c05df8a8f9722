// Reads recordings of objects (.npz: a zip archive of NumPy arrays), which hold clouds and the truth.
import { Matrix4, Quaternion } from "three";
import type { Recording } from "./recording";
import type { Vec3, Vec4 } from "./types";

const UNIT_M = 1e-4;
const ENCODING = "application/vnd.captra.cloud.i16";
type Numbers = Int16Array | Uint8Array | Float32Array | Float64Array | BigInt64Array;
interface Stored {
  values: Numbers | string;
  shape: number[];
}

export async function readNpz(name: string, file: ArrayBuffer): Promise<Recording> {
  const arrays = await unzip(file);
  const numbers = (key: string): Numbers => {
    const found = arrays.get(key)?.values;
    if (found === undefined || typeof found === "string") throw new Error(`${name} is no recording: it lacks ${key}`);
    return found;
  };
  const points = numbers("points") as Int16Array<ArrayBuffer>,
    offsets = [...(numbers("offsets") as BigInt64Array)].map(Number);
  const rotation = numbers("init_rotation") as Float32Array,
    translation = numbers("init_translation") as Float32Array,
    size = numbers("init_size") as Float32Array;
  const stored = arrays.get("category")?.values,
    stamps = numbers("stamp_ns") as BigInt64Array;
  const clouds = offsets.slice(1).map((end, i) => points.slice(3 * offsets[i], 3 * end));
  return {
    name,
    category: typeof stored === "string" ? stored : name.split("__")[0],
    options: {},
    frames: clouds.map((cloud, i) => ({
      stamp: stamps[i],
      encoding: ENCODING,
      payload: () => new Uint8Array(cloud.buffer),
      region: null,
      reset: null,
    })),
    points: Float32Array.from(clouds[0], (value) => value * UNIT_M),
    init: Array.from({ length: size.length / 3 }, (_, part) => {
      const m = rotation.slice(9 * part, 9 * part + 9);
      const q = new Quaternion()
        .setFromRotationMatrix(
          new Matrix4().set(m[0], m[1], m[2], 0, m[3], m[4], m[5], 0, m[6], m[7], m[8], 0, 0, 0, 0, 1),
        )
        .normalize();
      return {
        name: `part ${part}`,
        translation: [...translation.slice(3 * part, 3 * part + 3)] as Vec3,
        quat_xyzw: q.toArray() as Vec4,
        size: [...size.slice(3 * part, 3 * part + 3)] as Vec3,
      };
    }),
  };
}

async function unzip(file: ArrayBuffer): Promise<Map<string, Stored>> {
  const view = new DataView(file),
    found = new Map<string, Stored>();
  let end = file.byteLength - 22;
  while (end >= 0 && view.getUint32(end, true) !== 0x06054b50) end--;
  if (end < 0) throw new Error("this file is no recording: it is not whole");
  let at = view.getUint32(end + 16, true);
  for (let entry = view.getUint16(end + 10, true); entry > 0; entry--) {
    const [packed, nameLength, extra, comment] = [
      view.getUint32(at + 20, true),
      view.getUint16(at + 28, true),
      view.getUint16(at + 30, true),
      view.getUint16(at + 32, true),
    ];
    const name = new TextDecoder().decode(new Uint8Array(file, at + 46, nameLength)),
      local = view.getUint32(at + 42, true);
    const start = local + 30 + view.getUint16(local + 26, true) + view.getUint16(local + 28, true);
    let bytes: ArrayBuffer = file.slice(start, start + packed);
    if (view.getUint16(at + 10, true) === 8)
      bytes = await new Response(
        new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw")),
      ).arrayBuffer();
    found.set(name.replace(/\.npy$/, ""), readArray(name, bytes));
    at += 46 + nameLength + extra + comment;
  }
  return found;
}

function readArray(name: string, bytes: ArrayBuffer): Stored {
  const view = new DataView(bytes),
    wide = view.getUint8(6) > 1;
  const length = wide ? view.getUint32(8, true) : view.getUint16(8, true),
    begin = wide ? 12 : 10;
  const header = new TextDecoder().decode(new Uint8Array(bytes, begin, length)),
    data = bytes.slice(begin + length);
  const type = /'descr': '([^']+)'/.exec(header)?.[1] ?? "",
    shape = (/'shape': \(([^)]*)\)/.exec(header)?.[1] ?? "")
      .split(",")
      .filter((s) => s.trim())
      .map(Number);
  const readers: Record<string, (b: ArrayBuffer) => Numbers> = {
    "<i2": (b) => new Int16Array(b),
    "|u1": (b) => new Uint8Array(b),
    "<f4": (b) => new Float32Array(b),
    "<f8": (b) => new Float64Array(b),
    "<i8": (b) => new BigInt64Array(b),
  };
  if (type.startsWith("<U"))
    return { values: String.fromCodePoint(...new Uint32Array(data)).replace(/\0+$/, ""), shape };
  if (!(type in readers)) throw new Error(`${name} holds ${type} numbers, which recordings do not`);
  return { values: readers[type](data), shape };
}
