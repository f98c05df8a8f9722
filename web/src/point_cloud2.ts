// Points of a sensor_msgs/msg/PointCloud2 in CDR, to look at: metres, without pixels that see nothing.
import { CdrReader } from "@foxglove/cdr";

const FLOAT32 = 7;

export function pointsOf(message: Uint8Array): Float32Array {
  const reader = new CdrReader(message);
  reader.int32(); // stamp
  reader.uint32();
  reader.string(); // frame
  const [height, width] = [reader.uint32(), reader.uint32()];
  const fields = new Map<string, { offset: number; type: number }>();
  for (let count = reader.sequenceLength(); count > 0; count--) {
    const [name, offset, type] = [reader.string(), reader.uint32(), reader.uint8()];
    reader.uint32(); // how many values
    fields.set(name, { offset, type });
  }
  const little = reader.uint8() === 0;
  const [pointStep, rowStep] = [reader.uint32(), reader.uint32()];
  const data = reader.uint8Array();
  const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  const axes = ["x", "y", "z"].flatMap((name) => fields.get(name) ?? []);
  const found: number[] = [];
  for (let row = 0; row < height; row++) {
    for (let column = 0; column < width; column++) {
      const start = row * rowStep + column * pointStep;
      const point = axes.map(({ offset, type }) =>
        type === FLOAT32 ? view.getFloat32(start + offset, little) : view.getFloat64(start + offset, little),
      );
      if (point.every(Number.isFinite)) found.push(...point);
    }
  }
  return Float32Array.from(found);
}
