// A box a part, placed by hand: moved, turned and stretched with a gizmo, or by numbers.
import { Matrix4, Object3D, Quaternion, Vector3 } from "three";
import { TransformControls } from "three/addons/controls/TransformControls.js";
import { matrixOf } from "./boxes";
import type { View } from "./scene";
import { PLACING, type Category, type Part, type Vec3, type Vec4 } from "./types";
import typical from "./typical_boxes.json";

export type Mode = "translate" | "rotate" | "scale";
export const WHOLE = -1;
const SMALLEST = 1e-3; // metres
const SMALLEST_STRETCH = 0.05;
const Y_UP = { camera: new Quaternion(1, 0, 0, 0), robot: new Quaternion(Math.SQRT1_2, 0, 0, Math.SQRT1_2) };

export class Placing {
  parts: Part[] = [];
  category: Category | null = null;
  selected = WHOLE;
  private pivot = new Object3D();
  private gizmo: TransformControls;
  private from: { parts: Part[]; inverse: Matrix4 } = { parts: [], inverse: new Matrix4() };

  constructor(
    private view: View,
    canvas: HTMLElement,
    private changed: () => void,
  ) {
    this.gizmo = new TransformControls(view.camera, canvas);
    this.gizmo.setSpace("local");
    this.gizmo.setSize(0.85);
    this.gizmo.addEventListener("dragging-changed", ({ value }) => {
      view.controls.enabled = !value;
      if (!value) this.attach();
    });
    this.gizmo.addEventListener("change", view.draw);
    this.gizmo.addEventListener("objectChange", () => this.moved());
    view.extras.add(this.pivot, this.gizmo.getHelper());
    this.gizmo.enabled = this.gizmo.getHelper().visible = view.placing.group.visible = false;
  }

  get active(): boolean {
    return this.category !== null;
  }
  get mode(): Mode {
    return this.gizmo.mode as Mode;
  }
  get grabbed(): boolean {
    return this.gizmo.dragging || this.gizmo.axis !== null;
  }

  start(category: Category, parts: Part[]): void {
    this.category = category;
    this.parts = structuredClone(parts);
    this.selected = parts.length > 1 ? WHOLE : 0;
    this.gizmo.attach(this.pivot);
    this.gizmo.enabled = this.gizmo.getHelper().visible = this.view.placing.group.visible = true;
    this.attach();
  }

  end(): void {
    this.category = null;
    this.gizmo.detach();
    this.gizmo.enabled = this.gizmo.getHelper().visible = this.view.placing.group.visible = false;
    this.view.draw();
  }

  setMode(mode: Mode): void {
    this.gizmo.setMode(mode);
    this.changed();
    this.view.draw();
  }
  select(part: number): void {
    this.selected = part;
    this.attach();
  }

  // The object's centre, and so all its parts, to a place in the cloud.
  moveTo(place: Vector3): void {
    const shift = place.clone().sub(this.centre());
    this.parts.forEach((part) => (part.translation = new Vector3(...part.translation).add(shift).toArray() as Vec3));
    this.attach();
  }

  set(part: number, field: "translation" | "size", axis: number, value: number): void {
    if (!Number.isFinite(value) || (field === "size" && value <= 0)) return;
    this.parts[part][field][axis] = value;
    this.attach();
  }

  private centre(): Vector3 {
    return this.parts
      .reduce((sum, part) => sum.add(new Vector3(...part.translation)), new Vector3())
      .divideScalar(this.parts.length);
  }

  // The gizmo is put on what is selected; what it does from now on counts from here.
  private attach(): void {
    const part = this.parts[Math.max(0, this.selected)];
    this.pivot.position.copy(this.selected === WHOLE ? this.centre() : new Vector3(...part.translation));
    this.pivot.quaternion.fromArray(part.quat_xyzw);
    this.pivot.scale.setScalar(1);
    this.pivot.updateMatrix();
    this.from = { parts: structuredClone(this.parts), inverse: this.pivot.matrix.clone().invert() };
    this.show();
  }

  private moved(): void {
    if (this.selected === WHOLE) this.moveAll();
    else this.moveOne(this.parts[this.selected], this.from.parts[this.selected]);
    this.show();
  }

  private moveOne(part: Part, before: Part): void {
    const { position, quaternion, scale } = this.pivot;
    part.translation = position.toArray() as Vec3;
    part.quat_xyzw = quaternion.clone().normalize().toArray() as Vec4;
    part.size = before.size.map((v, axis) => Math.max(SMALLEST, v * Math.abs(scale.getComponent(axis)))) as Vec3;
  }

  // All parts keep their shape: whichever axis is pulled, they grow alike.
  private moveAll(): void {
    const { position, quaternion, scale } = this.pivot;
    const stretch = scale.toArray().reduce((a, b) => (Math.abs(b - 1) > Math.abs(a - 1) ? b : a));
    const alike = new Vector3().setScalar(Math.max(SMALLEST_STRETCH, stretch));
    const change = new Matrix4().compose(position, quaternion, alike).multiply(this.from.inverse);
    this.parts.forEach((part, i) => {
      const [t, q, s] = [new Vector3(), new Quaternion(), new Vector3()];
      change.clone().multiply(matrixOf(this.from.parts[i])).decompose(t, q, s);
      part.translation = t.toArray() as Vec3;
      part.quat_xyzw = q.normalize().toArray() as Vec4;
      part.size = s.toArray().map(Math.abs) as Vec3;
    });
  }

  private show(): void {
    this.view.placing.show(this.parts, PLACING);
    this.changed();
    this.view.draw();
  }
}

export function typicalParts(category: Category, centre: Vector3, up: "camera" | "robot"): Part[] {
  const boxes = (typical as unknown as Record<string, { translation: Vec3; size: Vec3 }[]>)[category.name];
  return category.parts.map((name, i) => ({
    name,
    size: [...boxes[i].size],
    quat_xyzw: Y_UP[up].toArray() as Vec4,
    translation: new Vector3(...boxes[i].translation).applyQuaternion(Y_UP[up]).add(centre).toArray() as Vec3,
  }));
}
