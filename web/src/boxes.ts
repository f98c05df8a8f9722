// Boxes, axes and names of an object's parts.
import { BoxGeometry, Color, Group, Matrix4, Mesh, MeshBasicMaterial, Quaternion, Vector3 } from "three";
import { CSS2DObject } from "three/addons/renderers/CSS2DRenderer.js";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { Part, Vec3 } from "./types";

const SIGNS: Vec3[] = [-0.5, 0.5].flatMap((x) => [-0.5, 0.5].flatMap((y) => [-0.5, 0.5].map((z) => [x, y, z] as Vec3)));
const EDGES = SIGNS.flatMap((a, i) =>
  SIGNS.slice(i + 1)
    .filter((b) => a.filter((v, k) => v !== b[k]).length === 1)
    .flatMap((b) => [...a, ...b]),
);
const AXIS_COLOURS = ["#ff5a5f", "#5fe07a", "#5b9dff"].flatMap((hex) => [...new Color(hex), ...new Color(hex)]);
const EDGE_GEOMETRY = new LineSegmentsGeometry().setPositions(EDGES);
const AXIS_GEOMETRY = new LineSegmentsGeometry()
  .setPositions([0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1])
  .setColors(AXIS_COLOURS);
const CUBE = new BoxGeometry(1, 1, 1);

export const matrixOf = (part: Part): Matrix4 =>
  new Matrix4().compose(new Vector3(...part.translation), new Quaternion(...part.quat_xyzw), new Vector3(...part.size));
export const cornersOf = (part: Part): Vector3[] =>
  SIGNS.map((sign) => new Vector3(...sign).applyMatrix4(matrixOf(part)));

class PartBox {
  readonly group = new Group();
  private edges = new LineMaterial({ linewidth: 2.6 });
  private ghost = new LineMaterial({ linewidth: 1.6, transparent: true, opacity: 0.35, depthTest: false });
  private fill = new MeshBasicMaterial({ transparent: true, opacity: 0.07, depthWrite: false });
  private box = new Group();
  private axes = new LineSegments2(
    AXIS_GEOMETRY,
    new LineMaterial({ linewidth: 3, vertexColors: true, depthTest: false, transparent: true }),
  );
  private tag: HTMLElement;

  constructor(name: string) {
    this.box.add(
      new LineSegments2(EDGE_GEOMETRY, this.edges),
      new LineSegments2(EDGE_GEOMETRY, this.ghost),
      new Mesh(CUBE, this.fill),
    );
    this.tag = Object.assign(document.createElement("div"), {
      className: "tag",
      textContent: name.replaceAll("_", " "),
    });
    const label = new CSS2DObject(this.tag);
    label.position.set(0, 0.5, 0);
    label.center.set(0.5, 1.3);
    this.box.add(label);
    this.group.add(this.box, this.axes);
  }

  show(part: Part, colour: string): void {
    matrixOf(part).decompose(this.box.position, this.box.quaternion, this.box.scale);
    this.axes.position.copy(this.box.position);
    this.axes.quaternion.copy(this.box.quaternion);
    this.axes.scale.setScalar(0.45 * Math.max(...part.size));
    for (const material of [this.edges, this.ghost, this.fill]) material.color.set(colour);
    this.tag.style.setProperty("--state", colour);
  }

  remove(): void {
    this.tag.remove();
    this.group.removeFromParent();
  }
}

export class ObjectBoxes {
  readonly group = new Group();
  private boxes: PartBox[] = [];
  private names = "";
  parts: Part[] = [];
  colour = "#ffffff";

  show(parts: Part[], colour: string): void {
    const names = parts.map((part) => part.name).join();
    if (names !== this.names) {
      this.boxes.forEach((box) => box.remove());
      this.boxes = parts.map((part) => new PartBox(part.name));
      this.group.add(...this.boxes.map((box) => box.group));
      this.names = names;
    }
    this.parts = parts;
    this.colour = colour;
    parts.forEach((part, i) => this.boxes[i].show(part, colour));
  }
}
