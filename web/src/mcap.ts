// Reads recordings of sessions (MCAP), as the service, its clients and `captra record` write them.
import { BinaryReader } from "@bufbuild/protobuf/wire";
import { McapStreamReader } from "@mcap/core";
import { decompress } from "lz4js";
import { Matrix3, Matrix4, Quaternion } from "three";
import { pointsOf } from "./point_cloud2";
import type { Frame, Recording } from "./recording";
import type { Part, Vec3, Vec4 } from "./types";

const POINTS_FIELD = 6; // "data" of foxglove.PointCloud
const CLOUDS = "/cloud"; // edges of boxes have a topic of their own
const BRACE = 0x7b; // older files have it as JSON

type Rotation = { quat_xyzw: Vec4 } | { matrix: number[][] };
interface Body {
  category: string;
  parts: { rotation: Rotation; translation: Vec3; size: Vec3 }[];
  record?: unknown;
  ros2?: unknown;
}

export function readMcap(name: string, file: ArrayBuffer): Recording {
  let body: Body | null = null,
    reset: Part[] | null = null,
    points: Float32Array | null = null,
    message: Uint8Array<ArrayBuffer> = new Uint8Array();
  const frames: Frame[] = [];
  for (const [schema, topic, data] of messages(name, file)) {
    switch (schema) {
      case "captra.Session":
        body ??= json(data);
        break;
      case "captra.Reset":
        reset = partsOf(json<Body>(data));
        break;
      case "captra.Frame":
        frames.push(frameOf(data, message, reset));
        reset = null;
        break;
      case "foxglove.PointCloud":
        if (topic === CLOUDS && data[0] !== BRACE)
          points ??= new Float32Array(bytesIn(data, POINTS_FIELD).slice().buffer);
        break;
      case "sensor_msgs/msg/PointCloud2":
        message = data.slice();
        points ??= pointsOf(message);
    }
  }
  if (body === null) throw new Error(`${name} is no recording of a session: captra record, or a session, writes them`);
  if (frames.length === 0) throw new Error(`${name} is empty: its session ended before a frame came`);
  const { category, parts: _, record: __, ros2: ___, ...options } = body;
  return { name, category, options, init: partsOf(body), frames, points };
}

function* messages(name: string, file: ArrayBuffer): Generator<[schema: string, topic: string, data: Uint8Array]> {
  const lz4 = (bytes: Uint8Array, size: bigint) => decompress(bytes, Number(size));
  const reader = new McapStreamReader({ decompressHandlers: { lz4 } });
  const schemas = new Map<number, string>(),
    channels = new Map<number, [schema: string, topic: string]>();
  reader.append(new Uint8Array(file));
  try {
    for (let record = reader.nextRecord(); record !== undefined; record = reader.nextRecord()) {
      if (record.type === "Schema") schemas.set(record.id, record.name);
      else if (record.type === "Channel") channels.set(record.id, [schemas.get(record.schemaId) ?? "", record.topic]);
      else if (record.type === "Message") yield [...(channels.get(record.channelId) ?? ["", ""]), record.data];
    }
  } catch (error) {
    throw new Error(`${name} cannot be read (${error instanceof Error ? error.message : error}): record it again`);
  }
}

// A stamp has more digits than a number of JavaScript.
function frameOf(data: Uint8Array, message: Uint8Array<ArrayBuffer>, reset: Part[] | null): Frame {
  const text = new TextDecoder().decode(data);
  const { encoding, payload, mask } = JSON.parse(text) as { encoding: string; payload?: string; mask?: string };
  return {
    stamp: BigInt(/"stamp_ns":\s*(-?\d+)/.exec(text)?.[1] ?? 0),
    encoding,
    payload: () => (payload === undefined ? message : bytesOf(payload)),
    region: mask === undefined ? null : bytesOf(mask),
    reset,
  };
}

// A field of a message of protobuf.
function bytesIn(message: Uint8Array, wanted: number): Uint8Array {
  const reader = new BinaryReader(message);
  while (reader.pos < reader.len) {
    const [field, type] = reader.tag();
    if (field === wanted) return reader.bytes();
    reader.skip(type);
  }
  return new Uint8Array();
}

const json = <T = Body>(data: Uint8Array): T => JSON.parse(new TextDecoder().decode(data));
const bytesOf = (base64: string) => Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));

function partsOf(body: Body): Part[] {
  return body.parts.map(({ rotation, translation, size }, index) => ({
    name: `part ${index}`,
    quat_xyzw: "quat_xyzw" in rotation ? rotation.quat_xyzw : quatOf(rotation.matrix),
    translation,
    size,
  }));
}

function quatOf(rows: number[][]): Vec4 {
  const [m11, m12, m13, m21, m22, m23, m31, m32, m33] = rows.flat();
  const rotation = new Matrix4().setFromMatrix3(new Matrix3(m11, m12, m13, m21, m22, m23, m31, m32, m33));
  return new Quaternion().setFromRotationMatrix(rotation).normalize().toArray() as Vec4;
}
