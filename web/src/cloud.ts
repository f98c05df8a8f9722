// The points of the scene: quantized as they came, coloured by depth, lit up where they lie within a box.
import { Box3, BufferAttribute, BufferGeometry, Color, Matrix4, Points, ShaderMaterial, Sphere, Vector3 } from "three";
import type { Cloud } from "./types";

const MOST_BOXES = 8;
const POINT_SIZE = 0.0038; // of the height of the view, at a metre
const UNIT = new Box3(new Vector3(-0.5, -0.5, -0.5), new Vector3(0.5, 0.5, 0.5));
const VERTEX = `
uniform float size, near, far, radius; uniform vec3 eye, centre; uniform mat4 boxes[${MOST_BOXES}]; uniform int count;
varying float depth, inside, behind;
void main() {
  vec4 world = modelMatrix * vec4(position, 1.0);
  depth = clamp((distance(world.xyz, eye) - near) / (far - near), 0.0, 1.0);
  behind = clamp(0.5 + (distance(world.xyz, cameraPosition) - distance(centre, cameraPosition)) / (2.0 * radius), 0.0, 1.0);
  inside = 0.0;
  for (int i = 0; i < ${MOST_BOXES}; i++) {
    vec3 p = abs((boxes[i] * world).xyz);
    if (i < count && max(p.x, max(p.y, p.z)) <= 0.52) inside = 1.0;
  }
  vec4 seen = viewMatrix * world;
  gl_Position = projectionMatrix * seen;
  gl_PointSize = clamp(size / max(0.05, -seen.z), 1.5, 7.0);
}`;
// The scene from near to far, the object from front to back; every point a little darker at its rim.
const FRAGMENT = `
uniform vec3 tint; varying float depth, inside, behind;
void main() {
  vec2 p = gl_PointCoord - 0.5;
  float off = dot(p, p);
  if (off > 0.25) discard;
  vec3 middle = vec3(0.26, 0.45, 0.62);
  vec3 scene = depth < 0.5
    ? mix(vec3(0.74, 0.83, 0.93), middle, 2.0 * depth)
    : mix(middle, vec3(0.25, 0.22, 0.42), 2.0 * depth - 1.0);
  vec3 object = mix(mix(vec3(1.0), tint, 0.3), 0.55 * tint, behind);
  gl_FragColor = vec4(mix(scene, object, inside) * (1.0 - 0.4 * smoothstep(0.06, 0.25, off)), 1.0);
}`;

export class PointCloud {
  readonly points: Points<BufferGeometry, ShaderMaterial>;
  private bounds = { near: 0, far: 1 };

  constructor() {
    const uniforms = {
      size: { value: 4 },
      radius: { value: 0.1 },
      centre: { value: new Vector3() },
      eye: { value: new Vector3() },
      near: { value: 0 },
      far: { value: 1 },
      tint: { value: new Color("#3ecf8e") },
      boxes: { value: Array.from({ length: MOST_BOXES }, () => new Matrix4()) },
      count: { value: 0 },
    };
    this.points = new Points(
      new BufferGeometry(),
      new ShaderMaterial({ uniforms, vertexShader: VERTEX, fragmentShader: FRAGMENT }),
    );
    this.points.frustumCulled = false;
    this.points.visible = false;
  }

  show(cloud: Cloud): void {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(cloud.quantized, 3));
    geometry.boundingSphere = new Sphere(new Vector3(), Infinity);
    this.points.geometry.dispose();
    this.points.geometry = geometry;
    this.points.position.fromArray(cloud.origin);
    this.points.scale.fromArray(cloud.step);
    this.points.updateMatrixWorld();
    this.points.visible = true;
    const distances: number[] = [],
      p = new Vector3();
    for (let i = 0; i < cloud.count; i += 37) distances.push(this.at(i, p).length());
    distances.sort((a, b) => a - b);
    const u = this.points.material.uniforms;
    u.near.value = this.bounds.near = distances[Math.floor(distances.length * 0.02)];
    u.far.value = this.bounds.far = distances[Math.floor(distances.length * 0.98)] + 0.05;
  }

  hide(): void {
    this.points.visible = false;
  }

  get count(): number {
    return this.points.visible ? (this.points.geometry.getAttribute("position")?.count ?? 0) : 0;
  }

  at(index: number, into: Vector3): Vector3 {
    return into
      .fromBufferAttribute(this.points.geometry.getAttribute("position"), index)
      .multiply(this.points.scale)
      .add(this.points.position);
  }

  median(): Vector3 {
    const axes: number[][] = [[], [], []],
      p = new Vector3();
    for (let i = 0; i < this.count; i += 11)
      this.at(i, p)
        .toArray()
        .forEach((v, axis) => axes[axis].push(v));
    return new Vector3(...axes.map((axis) => axis.sort((a, b) => a - b)[axis.length >> 1] ?? 0));
  }

  light(boxes: Matrix4[], colour: string, pixels: number): void {
    const u = this.points.material.uniforms;
    const hull = new Box3();
    boxes.slice(0, MOST_BOXES).forEach((box, i) => {
      (u.boxes.value[i] as Matrix4).copy(box).invert();
      hull.union(UNIT.clone().applyMatrix4(box));
    });
    u.count.value = Math.min(boxes.length, MOST_BOXES);
    (u.tint.value as Color).set(colour).convertLinearToSRGB(); // the shader writes what is seen
    hull.getCenter(u.centre.value);
    u.radius.value = Math.max(0.01, 0.35 * hull.getSize(new Vector3()).length());
    u.size.value = pixels * POINT_SIZE;
  }
}

export function quantize(points: Float32Array): Cloud {
  const origin = [Infinity, Infinity, Infinity],
    top = [-Infinity, -Infinity, -Infinity];
  points.forEach((v, i) => {
    origin[i % 3] = Math.min(origin[i % 3], v);
    top[i % 3] = Math.max(top[i % 3], v);
  });
  const step = top.map((v, axis) => Math.max((v - origin[axis]) / 65535, 1e-9));
  const quantized = Uint16Array.from(points, (v, i) => Math.round((v - origin[i % 3]) / step[i % 3]));
  return {
    quantized,
    origin: origin as Cloud["origin"],
    step: step as Cloud["step"],
    count: points.length / 3,
    of: points.length / 3,
  };
}
