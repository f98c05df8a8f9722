// The 3D view: camera, light work of drawing only when something changed, picking of points.
import { Color, Group, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { Line2 } from "three/addons/lines/Line2.js";
import { LineGeometry } from "three/addons/lines/LineGeometry.js";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { CSS2DRenderer } from "three/addons/renderers/CSS2DRenderer.js";
import { ObjectBoxes, matrixOf } from "./boxes";
import { PointCloud } from "./cloud";

export type Up = "camera" | "robot";
const UPS: Record<Up, Vector3> = { camera: new Vector3(0, -1, 0), robot: new Vector3(0, 0, 1) };
const TRAIL = 300,
  REACH_PX = 14;

const TRAIL_COLOUR = [...new Color("#ffd166")];

export class View {
  readonly camera = new PerspectiveCamera(48, 1, 0.01, 100);
  readonly scene = new Scene();
  readonly cloud = new PointCloud();
  readonly object = new ObjectBoxes();
  readonly placing = new ObjectBoxes();
  readonly extras = new Group();
  controls: OrbitControls;
  readonly renderer: WebGLRenderer;
  private labels: CSS2DRenderer;
  private trail = new Line2(
    new LineGeometry(),
    new LineMaterial({ linewidth: 2.5, vertexColors: true, depthTest: false, transparent: true }),
  );
  private trailPoints: Vector3[] = [];
  private pending = false;
  private framed = false;
  up: Up = "camera";

  constructor(
    private canvas: HTMLCanvasElement,
    labels: HTMLElement,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.labels = new CSS2DRenderer({ element: labels });
    this.scene.background = new Color("#0d1117");
    this.trail.visible = false;
    this.trail.frustumCulled = false;
    this.scene.add(this.cloud.points, this.object.group, this.placing.group, this.trail, this.extras);
    this.controls = this.newControls();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement!);
    this.resize();
  }

  draw = (): void => {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => {
      this.pending = false;
      const lit = this.placing.group.visible ? this.placing : this.object;
      this.cloud.light(lit.group.visible ? lit.parts.map(matrixOf) : [], lit.colour, this.canvas.height);
      this.renderer.render(this.scene, this.camera);
      this.labels.render(this.scene, this.camera);
    });
  };

  setUp(up: Up): void {
    this.up = up;
    this.controls.dispose();
    this.controls = this.newControls(this.controls.target);
    this.lookAt(this.controls.target.clone(), this.camera.position.distanceTo(this.controls.target));
  }

  // The first cloud is looked at from where it was seen.
  frameOnce(): void {
    if (this.framed || this.cloud.count === 0) return;
    this.framed = true;
    const middle = this.cloud.median();
    this.lookAt(middle, middle.length() * 0.72);
  }

  frameAgain(): void {
    this.framed = false;
  }

  lookAt(target: Vector3, distance: number): void {
    const up = UPS[this.up],
      towards = target.clone().projectOnPlane(up);
    if (towards.lengthSq() < 1e-6) towards.set(0, 0, 1);
    this.camera.position
      .copy(target)
      .addScaledVector(towards.normalize(), -distance * 0.93)
      .addScaledVector(up, distance * 0.32);
    this.controls.target.copy(target);
    this.controls.update();
    this.camera.updateMatrixWorld();
    this.draw();
  }

  follow(centre: Vector3): void {
    const last = this.trailPoints[this.trailPoints.length - 1];
    if (last !== undefined && last.distanceTo(centre) < 1e-4) return;
    this.trailPoints.push(centre);
    if (this.trailPoints.length > TRAIL) this.trailPoints.shift();
    if (this.trailPoints.length < 2) return;
    const geometry = new LineGeometry(),
      n = this.trailPoints.length;
    geometry.setPositions(this.trailPoints.flatMap((p) => p.toArray()));
    geometry.setColors(this.trailPoints.flatMap((_, i) => TRAIL_COLOUR.map((v) => v * (0.15 + (0.85 * i) / n))));
    this.trail.geometry.dispose();
    this.trail.geometry = geometry;
    this.trail.visible = true;
  }

  forgetTrail(): void {
    this.trailPoints = [];
    this.trail.visible = false;
  }
  get trailLength(): number {
    return this.trailPoints.length;
  }

  // CSS pixels within the canvas.
  project(point: Vector3): [number, number] {
    const p = point.clone().project(this.camera);
    return [((p.x + 1) / 2) * this.canvas.clientWidth, ((1 - p.y) / 2) * this.canvas.clientHeight];
  }

  pick(x: number, y: number): Vector3 | null {
    const p = new Vector3(),
      best = new Vector3();
    let nearest = Infinity;
    this.camera.updateMatrixWorld();
    for (let i = 0; i < this.cloud.count; i++) {
      const [u, v] = this.project(this.cloud.at(i, p)),
        off = Math.hypot(u - x, v - y);
      const cost = p.distanceTo(this.camera.position) + 0.02 * off;
      if (off < REACH_PX && cost < nearest) {
        nearest = cost;
        best.copy(p);
      }
    }
    return nearest < Infinity ? best : null;
  }

  private newControls(target?: Vector3): OrbitControls {
    this.camera.up.copy(UPS[this.up]);
    const controls = new OrbitControls(this.camera, this.canvas);
    controls.zoomToCursor = true;
    controls.target.copy(target ?? new Vector3(0, 0, 1));
    controls.addEventListener("change", this.draw);
    return controls;
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement!;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.labels.setSize(width, height);
    this.camera.aspect = width / Math.max(1, height);
    this.camera.updateProjectionMatrix();
    this.draw();
  }
}
