import type { Robot, World } from "../api/model";
import { IDLE, isLive, type Pose, type RunView } from "../run/reducer";
import { type Point, points } from "../run/trail";
import { BoxInterpolator } from "./box_interpolator";
import { type Bundle, type BundlePath, drawBundle, pathAt } from "./bundle/bundle";
import { type Colours, readColours } from "./colours";
import { type Companion, drawCompanion } from "./companion";
import { drawMovableBoxes, drawRulers } from "./floor";
import { HANDLE_M, startOf, toStartFrame, toWorld, type XY } from "./frames";
import { contentBounds } from "./framing/content_bounds";
import { FramedViewport, type Framing } from "./framing/framed_viewport";
import { hasRulers, type Size, toScreen, type Viewport, viewportFor } from "./framing/viewport";
import type { Livery } from "./livery/livery";
import { hasPlateBelow } from "./mat/places";
import { drawRanges, type Measurements } from "./ranges_view";
import { drawBelief, drawKnob, drawRobot } from "./robot";
import { type CacheInput, SceneCache } from "./scene_cache";
import type { NameSide, RobotPlace } from "./signs/bubble_view";
import { sideOfName } from "./signs/name_side";
import { RobotSigns, reachOf } from "./signs/robot_signs";

/** Redraws continue for this time after the last change, until the interpolated pose has arrived; ms. */
const LINGER_MS = 250;

/** How far from a path of a bundle a click still means it. */
const REACH_PX = 12;

/** The estimated pose is drawn if it differs from the true pose by more than this. */
export const OFF_M = 0.01;

/** Draws over the floor, in pixels. */
export type Overlay = (
  ctx: CanvasRenderingContext2D,
  viewport: Viewport,
  size: Size,
  colours: Colours,
) => void;

/** Redraws the floor from above after a change, at most once per animation frame. */
export class SceneRenderer {
  private readonly ctx: CanvasRenderingContext2D;
  private colours: Colours = readColours();
  private world: World | null = null;
  private robot: Robot | null = null;
  private view: RunView = IDLE;
  /** The state whose whole path the viewport shows. */
  private whole: RunView = IDLE;
  private size: Size = { width: 1, height: 1 };
  private ratio = 1;
  /** How much larger everything is drawn that has a size in pixels. */
  private magnification = 1;
  private redrawUntil = 0;
  private handle = 0;
  private lastFrame = 0;
  private cache = new SceneCache();
  private readonly boxInterpolator = new BoxInterpolator();
  private ranges: Measurements | null = null;
  /** Whether the robot is at its start and can be dragged. */
  private movable = false;
  private overlay: Overlay | null = null;
  private companion: Companion | null = null;
  private bundle: Bundle | null = null;
  private livery: Livery | null = null;
  private readonly signs = new RobotSigns();
  private readonly viewport: FramedViewport;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly poseAt: (now: number) => Pose,
    private readonly still: () => boolean,
    onFraming: (framing: Framing) => void = () => {},
    hasControls = false,
  ) {
    const ctx = canvas.getContext("2d");
    if (!ctx) throw new Error("no 2D canvas");
    this.ctx = ctx;
    this.viewport = new FramedViewport(() => {
      const { world, whole, companion, bundle, size, magnification } = this;
      return { world, whole, companion, bundle, size, magnification, hasControls };
    }, onFraming);
  }

  setWorld(world: World | null): void {
    if (world === this.world) return;
    const sameRoom = world !== null && this.world?.walls === world.walls;
    this.world = world;
    if (sameRoom) {
      // only the start pose differs
      this.viewport.invalidate();
    } else {
      this.viewport.reset();
    }
    this.requestRedraw();
  }

  setRobot(robot: Robot | null): void {
    this.robot = robot;
    this.requestRedraw();
  }

  setLivery(livery: Livery | null): void {
    this.livery = livery;
    this.requestRedraw();
  }

  setMovable(movable: boolean): void {
    this.movable = movable;
    this.requestRedraw();
  }

  setRanges(ranges: Measurements | null): void {
    this.ranges = ranges;
    this.requestRedraw();
  }

  setOverlay(overlay: Overlay | null): void {
    this.overlay = overlay;
    this.requestRedraw();
  }

  /** Changes the signs at the robot: what it says, its beep, a celebration. */
  sign(change: (signs: RobotSigns) => void): void {
    change(this.signs);
    this.requestRedraw();
  }

  /** Sets the second run on this floor. */
  setCompanion(companion: Companion | null): void {
    this.companion = companion;
    this.viewport.invalidate();
    this.requestRedraw();
  }

  /** Sets the paths of many robots on this floor. */
  setBundle(bundle: Bundle | null): void {
    this.bundle = bundle;
    this.viewport.invalidate();
    this.requestRedraw();
  }

  /** The path of the bundle at a point of the world frame, within some pixels; null without one. */
  pathAt(at: XY): BundlePath | null {
    return this.bundle && pathAt(this.bundle, at, REACH_PX * this.pixel);
  }

  /** Fixes the viewport while the user drags something. */
  hold(held: boolean): void {
    this.viewport.hold(held);
    this.requestRedraw();
  }

  /** Turns following the robot on or off. */
  follow(isOn: boolean): void {
    this.viewport.follow(isOn);
    this.requestRedraw();
  }

  /** Converts a point of the canvas to the world frame. */
  floorAt(place: XY): XY {
    return this.viewport.floorAt(place);
  }

  /** Size of a pixel in metres. */
  get pixel(): number {
    return 1 / (this.viewport.current.scale * this.magnification);
  }

  get shownWorld(): World | null {
    return this.world;
  }

  /** Position of the robot in the world frame. */
  get robotAt(): XY {
    const pose = this.poseAt(performance.now());
    return toWorld(startOf(this.world), pose.x, pose.y);
  }

  /**
   * Draws a state. The viewport shows the path of `whole`, so it does not move while ticks of one
   * run are inspected.
   */
  setView(view: RunView, whole = view): void {
    this.view = view;
    this.whole = whole;
    this.viewport.invalidate();
    this.requestRedraw();
  }

  setTheme(): void {
    this.colours = readColours();
    this.requestRedraw();
  }

  resize(width: number, height: number, magnification = 1): void {
    this.size = { width: width / magnification, height: height / magnification };
    this.magnification = magnification;
    this.ratio = (window.devicePixelRatio || 1) * magnification;
    this.canvas.width = Math.round(this.size.width * this.ratio);
    this.canvas.height = Math.round(this.size.height * this.ratio);
    this.viewport.jump();
    this.requestRedraw();
    this.draw(performance.now());
  }

  /** Shows the subject; if the viewport already shows it, shows the whole room. */
  frame(): void {
    this.viewport.fit();
    this.requestRedraw();
  }

  zoom(factor: number): void {
    this.viewport.zoom(factor);
    this.requestRedraw();
  }

  pan(dx: number, dy: number): void {
    this.viewport.pan(dx, dy);
    this.requestRedraw();
  }

  dispose(): void {
    cancelAnimationFrame(this.handle);
  }

  /** Draws the whole subject with the given palette on a new canvas, for export. */
  picture(size: Size, ratio: number, colours: Colours): HTMLCanvasElement {
    return this.pictures(size, ratio, colours)();
  }

  /**
   * Returns a function that draws the state of the time of its call, for a series of pictures. All
   * are drawn on one canvas, and show the same part of the floor: that of the whole path.
   */
  pictures(size: Size, ratio: number, colours: Colours): () => HTMLCanvasElement {
    const canvas = document.createElement("canvas");
    canvas.width = size.width * ratio;
    canvas.height = size.height * ratio;
    const ctx = canvas.getContext("2d");
    const viewport = viewportFor(contentBounds(this.world, this.whole, this.companion), size);
    const cache = new SceneCache();
    return () => {
      if (!ctx) return canvas;
      const now = performance.now();
      const { world, robot, view } = this;
      const input = { world, robot, view, colours, size, ratio };
      this.boxInterpolator.approach(view.boxes, 0, true);
      this.paintCached(ctx, input, cache, viewport, now);
      this.drawSigns(ctx, input, this.poseAt(now), viewport, now);
      return canvas;
    };
  }

  private requestRedraw(): void {
    this.redrawUntil = performance.now() + LINGER_MS;
    this.handle ||= requestAnimationFrame((now) => this.tick(now));
  }

  private tick(now: number): void {
    this.handle = 0;
    const moving = this.draw(now);
    if (moving || now < this.redrawUntil) {
      this.handle = requestAnimationFrame((next) => this.tick(next));
    }
  }

  private draw(now: number): boolean {
    if (this.size.width === 0) return false; // hidden
    const pose = this.poseAt(now);
    const elapsed = Math.min(50, now - this.lastFrame);
    this.lastFrame = now;
    const place = toWorld(startOf(this.world), pose.x, pose.y);
    const moving = this.viewport.advance(place, elapsed, this.still());
    const pushing = this.boxInterpolator.approach(this.view.boxes, elapsed, this.still());
    const { world, robot, view, colours, size, ratio } = this;
    const input = { world, robot, view, colours, size, ratio };
    const viewport = this.cache.aligned(this.viewport.current, ratio);
    const blurred = this.paintCached(this.ctx, input, this.cache, viewport, now);
    const celebrating = this.drawSigns(this.ctx, input, pose, viewport, now);
    this.overlay?.(this.ctx, viewport, size, colours);
    return moving || pushing || blurred || celebrating;
  }

  /** Draws everything except the overlay; returns true while the cached image needs a redraw. */
  private paintCached(
    ctx: CanvasRenderingContext2D,
    input: CacheInput,
    cache: SceneCache,
    viewport: Viewport,
    now: number,
  ): boolean {
    const { world, colours, size, ratio } = input;
    ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
    ctx.fillStyle = colours.outside;
    ctx.fillRect(0, 0, size.width, size.height);
    const blurred = cache.drawImage(ctx, input, viewport, now);
    const pose = this.poseAt(now);
    const end: Point | null = this.view.run ? [pose.x, pose.y] : null;
    onFloor(ctx, input, viewport, () => {
      drawMovableBoxes(ctx, world, this.boxInterpolator.poses, colours);
      if (this.bundle) drawBundle(ctx, this.bundle, viewport, colours);
      toStartFrame(ctx, world);
      cache.drawPaths(ctx, input, viewport, end);
    });
    cache.drawStrokeLayer(ctx, input, viewport);
    const { companion } = this;
    if (companion) {
      onFloor(ctx, input, viewport, () => drawCompanion(ctx, companion, viewport, colours, ratio));
    }
    onFloor(ctx, input, viewport, () => {
      toStartFrame(ctx, world);
      cache.drawPen(ctx, input, viewport, end);
      this.drawRobot(ctx, pose, viewport, input);
    });
    if (hasRulers(this.magnification, size)) drawRulers(ctx, world, viewport, size, colours);
    return blurred;
  }

  private drawSigns(
    ctx: CanvasRenderingContext2D,
    { world, robot, size, colours, view }: CacheInput,
    pose: Pose,
    viewport: Viewport,
    now: number,
  ): boolean {
    const { livery } = this;
    const { scale } = viewport;
    const robotAt = toWorld(startOf(world), pose.x, pose.y);
    const at = toScreen(viewport, size, robotAt);
    const radius_m = robot?.radius_m ?? 0;
    const atRest = robot !== null && !isLive(view);
    const place = { at, size, reach: reachOf(radius_m, scale) };
    const nameSide = atRest ? this.nameSide(robotAt, place, viewport) : "below";
    const frame = { at, size, radius_m, scale, nameSide, livery, atRest };
    return this.signs.draw(ctx, frame, now, this.still(), colours);
  }

  /** The side for the robot's name that its path and the name of its place leave free. */
  private nameSide(robotAt: XY, place: RobotPlace, viewport: Viewport): NameSide {
    const { world, view } = this;
    const start = startOf(world);
    const path = Array.from(points(view.path), ([x, y]) =>
      toScreen(viewport, place.size, toWorld(start, x, y)),
    );
    const hasPlate = world !== null && hasPlateBelow(world, robotAt, 1 / viewport.scale);
    return sideOfName(path, place, hasPlate ? ["above"] : undefined);
  }

  private drawRobot(
    ctx: CanvasRenderingContext2D,
    pose: Pose,
    { scale }: Viewport,
    { robot, colours, ratio }: CacheInput,
  ): void {
    const { view, ranges } = this;
    if (!robot) return;
    if (ranges) {
      ctx.save();
      ctx.translate(pose.x, pose.y);
      ctx.rotate(pose.yaw);
      drawRanges(ctx, robot, ranges, colours, 1 / scale);
      ctx.restore();
    }
    if (this.movable && !view.run) drawKnob(ctx, robot, HANDLE_M, colours, 1 / scale);
    drawRobot(ctx, robot, pose, colours, scale * ratio, this.livery);
    const off = { x: view.pose.x - view.truth.x, y: view.pose.y - view.truth.y };
    if (Math.hypot(off.x, off.y) < OFF_M) return;
    const yaw = pose.yaw + view.pose.yaw - view.truth.yaw;
    drawBelief(ctx, robot, { x: pose.x + off.x, y: pose.y + off.y, yaw }, colours, 1 / scale);
  }
}

/** Runs a function with the canvas in the world frame: metres, y up. */
function onFloor(
  ctx: CanvasRenderingContext2D,
  { size }: CacheInput,
  viewport: Viewport,
  draw: () => void,
): void {
  ctx.save();
  ctx.translate(size.width / 2, size.height / 2);
  ctx.scale(viewport.scale, -viewport.scale);
  ctx.translate(-viewport.x, -viewport.y);
  draw();
  ctx.restore();
}
