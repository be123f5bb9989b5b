import type { World } from "../api/model";
import { IDLE, type Pose, type RunView } from "../run/reducer";
import { points, type Trail } from "../run/trail";
import { approach, type Camera, cameraFor, clampScale, type Size } from "./camera";
import { drawMarks, drawStrokes } from "./drawings";
import { drawFloor, drawRulers } from "./floor";
import { startOf } from "./frames";
import { type Palette, readPalette } from "./palette";
import { drawRobot, drawStart } from "./robot";
import { subjectOf, wholeRoom } from "./subject";

/** After the last change the picture is drawn on for so long, for the robot to arrive. */
const LINGER_MS = 250;

export type Framing = "subject" | "room" | "hand";

/** Draws the floor from above whenever something changes, at most once a frame of the screen. */
export class SceneRenderer {
  private readonly ctx: CanvasRenderingContext2D;
  private palette: Palette = readPalette();
  private world: World | null = null;
  private view: RunView = IDLE;
  private size: Size = { width: 1, height: 1 };
  private ratio = 1;
  private camera: Camera | null = null;
  private target: Camera = { x: 0, y: 0, scale: 60 };
  private framing: Framing = "subject";
  private awakeUntil = 0;
  private handle = 0;
  private lastFrame = 0;
  private moved = false;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly poseAt: (now: number) => Pose,
    private readonly still: () => boolean,
  ) {
    const ctx = canvas.getContext("2d");
    if (!ctx) throw new Error("no 2D canvas");
    this.ctx = ctx;
  }

  setWorld(world: World | null): void {
    if (world === this.world) return;
    this.world = world;
    this.framing = "subject";
    this.camera = null;
    this.aim();
  }

  setView(view: RunView): void {
    this.view = view;
    // the camera is aimed when the picture is drawn: many events may come between two pictures
    this.moved = true;
    this.wake();
  }

  setTheme(): void {
    this.palette = readPalette();
    this.wake();
  }

  resize(width: number, height: number): void {
    this.size = { width, height };
    this.ratio = window.devicePixelRatio || 1;
    this.canvas.width = Math.round(width * this.ratio);
    this.canvas.height = Math.round(height * this.ratio);
    this.camera = null;
    this.aim();
    this.draw(performance.now());
  }

  /** Shows what is worth seeing, or the whole room when that is what was shown. */
  frame(): void {
    this.framing = this.framing === "subject" ? "room" : "subject";
    this.aim();
  }

  zoom(factor: number): void {
    this.framing = "hand";
    this.target = { ...this.target, scale: clampScale(this.target.scale * factor) };
    this.wake();
  }

  pan(dx: number, dy: number): void {
    this.framing = "hand";
    const { x, y, scale } = this.target;
    this.target = { x: x - dx / scale, y: y + dy / scale, scale };
    this.camera = { ...this.target };
    this.wake();
  }

  dispose(): void {
    cancelAnimationFrame(this.handle);
  }

  private aim(): void {
    this.point();
    this.wake();
  }

  private point(): void {
    this.moved = false;
    if (this.framing === "subject")
      this.target = cameraFor(subjectOf(this.world, this.view), this.size);
    if (this.framing === "room") this.target = cameraFor(wholeRoom(this.world), this.size);
  }

  private wake(): void {
    this.awakeUntil = performance.now() + LINGER_MS;
    this.handle ||= requestAnimationFrame((now) => this.tick(now));
  }

  private tick(now: number): void {
    this.handle = 0;
    const moving = this.draw(now);
    if (moving || now < this.awakeUntil) {
      this.handle = requestAnimationFrame((next) => this.tick(next));
    }
  }

  private draw(now: number): boolean {
    if (this.moved) this.point();
    this.camera ??= { ...this.target };
    const elapsed = Math.min(50, now - this.lastFrame);
    this.lastFrame = now;
    const moving = approach(this.camera, this.target, elapsed, this.still());
    this.paint(this.camera, this.poseAt(now));
    return moving;
  }

  private paint(camera: Camera, pose: Pose): void {
    const { ctx, palette, size, ratio, world } = this;
    ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
    ctx.fillStyle = palette.outside;
    ctx.fillRect(0, 0, size.width, size.height);
    ctx.save();
    ctx.translate(size.width / 2, size.height / 2);
    ctx.scale(camera.scale, -camera.scale);
    ctx.translate(-camera.x, -camera.y);
    drawFloor(ctx, world, palette, camera.scale);
    const start = startOf(world);
    ctx.translate(start.x, start.y);
    ctx.rotate(start.yaw);
    drawStart(ctx, palette, camera.scale);
    drawMarks(ctx, this.view.output.marks, palette);
    this.drawPath(camera, pose);
    drawStrokes(ctx, this.view.output, pose, palette, 1 / camera.scale);
    drawRobot(ctx, pose, palette, camera.scale * ratio);
    ctx.restore();
    drawRulers(ctx, world, camera, size, palette);
  }

  private drawPath(camera: Camera, pose: Pose): void {
    const { ctx, palette } = this;
    const pixel = 1 / camera.scale;
    ctx.lineCap = "round";
    ctx.lineJoin = "round";
    // beneath the path, so that it is seen where the robot did not do what it should
    ctx.strokeStyle = palette.ideal;
    ctx.lineWidth = 2 * pixel;
    ctx.setLineDash([5 * pixel, 6 * pixel]);
    line(ctx, this.view.idealPath);
    ctx.stroke();
    ctx.setLineDash([]);
    ctx.strokeStyle = palette.path;
    ctx.lineWidth = 6 * pixel;
    line(ctx, this.view.path);
    if (this.view.run) ctx.lineTo(pose.x, pose.y);
    ctx.stroke();
  }
}

function line(ctx: CanvasRenderingContext2D, trail: Trail): void {
  ctx.beginPath();
  for (const [x, y] of points(trail)) ctx.lineTo(x, y);
}
