import type { Robot, World } from "../api/model";
import type { Output, Stroke } from "../run/output";
import type { RunView } from "../run/reducer";
import { lastPoint, type Point, type Trail } from "../run/trail";
import type { Colours } from "./colours";
import { drawMarks, drawStroke } from "./drawings";
import { drawFloor } from "./floor";
import { toStartFrame } from "./frames";
import type { Size, Viewport } from "./framing/viewport";
import { drawStart } from "./robot";

type Ctx = CanvasRenderingContext2D;

/** Input of the cached image. */
export interface CacheInput {
  readonly world: World | null;
  readonly robot: Robot | null;
  readonly view: RunView;
  readonly colours: Colours;
  readonly size: Size;
  readonly ratio: number;
}

/** A full redraw faster than QUICK_MS may happen in every frame, a slower redraw once per AGAIN_MS; ms. */
const QUICK_MS = 5;
const AGAIN_MS = 150;

/** Margin of the cached image around the viewport, so that small moves need no redraw; pixels. */
const MARGIN = 128;

/** How much of a line is drawn in the cache. */
interface DrawnLength {
  chunks: number;
  /** Drawn length in metres: the dash pattern continues from it. */
  length: number;
}

/**
 * Image cache of the floor and of everything on it that no longer changes: full chunks of the
 * paths, marks, finished strokes of the pen. Newer parts are drawn on top. A frame therefore costs
 * the same in a long run as in a short one. The cache moves with the viewport. If the viewport
 * zooms and a redraw is slow, the old image is scaled meanwhile.
 */
export class SceneCache {
  private readonly canvas = document.createElement("canvas");
  private readonly ctx = this.canvas.getContext("2d");
  /** Second layer, for marks and the pen's strokes: they lie above the path and its newest part. */
  private readonly strokeCanvas = document.createElement("canvas");
  private readonly strokeCtx = this.strokeCanvas.getContext("2d");
  private input: CacheInput | null = null;
  private viewport: Viewport = { x: 0, y: 0, scale: 1 };
  private path: DrawnLength = { chunks: 0, length: 0 };
  private ideal: DrawnLength = { chunks: 0, length: 0 };
  private strokes = 0;
  /** How much of the pen's unfinished stroke is drawn in the cache. */
  private pen: DrawnLength = { chunks: 0, length: 0 };
  private cost = 0;
  private drawnAt = 0;

  /** Draws the cached floor and paths; returns true while the image is scaled or shifted and needs a redraw. */
  drawImage(target: Ctx, input: CacheInput, viewport: Viewport, now: number): boolean {
    const { canvas, ctx } = this;
    // a hidden pane has no size, and a canvas without size cannot be drawn
    if (!ctx || input.size.width === 0 || input.size.height === 0) return false;
    const same = this.isSame(input);
    const mayWait = same && this.cost > QUICK_MS && now - this.drawnAt < AGAIN_MS;
    if (!same || (!this.covers(viewport) && !mayWait)) this.redraw(ctx, input, viewport, now);
    else this.extend(ctx, input);
    this.put(target, canvas, input, viewport);
    return !this.covers(viewport);
  }

  /** Draws marks and the pen's strokes over the paths. */
  drawStrokeLayer(target: Ctx, input: CacheInput, viewport: Viewport): void {
    const parts = this.strokes + this.pen.chunks + input.view.output.marks.length;
    if (parts > 0) this.put(target, this.strokeCanvas, input, viewport);
  }

  private put(target: Ctx, image: HTMLCanvasElement, input: CacheInput, viewport: Viewport): void {
    const scale = viewport.scale / this.viewport.scale;
    const [width, height] = [input.size.width + 2 * MARGIN, input.size.height + 2 * MARGIN];
    const left = (this.viewport.x - viewport.x) * viewport.scale - (width * scale) / 2;
    const top = -(this.viewport.y - viewport.y) * viewport.scale - (height * scale) / 2;
    const [middleX, middleY] = [input.size.width / 2, input.size.height / 2];
    target.drawImage(image, middleX + left, middleY + top, width * scale, height * scale);
  }

  /** Shifts the viewport by less than a pixel, so that pixels of the cache align with pixels of the screen. */
  aligned(viewport: Viewport, ratio: number): Viewport {
    if (viewport.scale !== this.viewport.scale) return viewport;
    const pixels = viewport.scale * ratio;
    const whole = (value: number, from: number) =>
      from + Math.round((value - from) * pixels) / pixels;
    return {
      ...viewport,
      x: whole(viewport.x, this.viewport.x),
      y: whole(viewport.y, this.viewport.y),
    };
  }

  private covers({ x, y, scale }: Viewport): boolean {
    const far = Math.max(Math.abs(x - this.viewport.x), Math.abs(y - this.viewport.y)) * scale;
    return scale === this.viewport.scale && far <= MARGIN;
  }

  /** Whether the cache is still valid: the input continues the cached paths, marks and strokes. */
  private isSame({ world, robot, view, colours, size, ratio }: CacheInput): boolean {
    const { input } = this;
    return (
      input !== null &&
      input.world === world &&
      input.robot === robot &&
      input.colours === colours &&
      input.size === size &&
      input.ratio === ratio &&
      input.view.run === view.run &&
      hasSameMarks(input.view.output, view.output) &&
      begins(input.view.path, view.path, this.path.chunks) &&
      begins(input.view.idealPath, view.idealPath, this.ideal.chunks) &&
      hasSameStroke(input.view.output, view.output, this.strokes - 1) &&
      this.holdsPen(view.output)
    );
  }

  /** Whether the pen's cached stroke is still unfinished, or is now one of the finished strokes. */
  private holdsPen({ pen, strokes }: Output): boolean {
    if (this.pen.chunks === 0) return true;
    const before = this.input?.view.output.pen;
    if (!before) return false;
    const isSame = (stroke: Stroke | null) =>
      stroke !== null && begins(before.trail, stroke.trail, this.pen.chunks);
    return isSame(pen) || strokes.slice(this.strokes).some(isSame);
  }

  private redraw(ctx: Ctx, input: CacheInput, viewport: Viewport, now: number): void {
    const { canvas } = this;
    const { size, ratio, colours, world, robot } = input;
    this.viewport = { ...viewport };
    this.path = { chunks: 0, length: 0 };
    this.ideal = { chunks: 0, length: 0 };
    this.strokes = 0;
    this.pen = { chunks: 0, length: 0 };
    canvas.width = Math.round((size.width + 2 * MARGIN) * ratio);
    canvas.height = Math.round((size.height + 2 * MARGIN) * ratio);
    this.strokeCanvas.width = canvas.width;
    this.strokeCanvas.height = canvas.height;
    const before = performance.now();
    ctx.setTransform(1, 0, 0, 1, 0, 0);
    ctx.fillStyle = colours.outside;
    ctx.fillRect(0, 0, canvas.width, canvas.height);
    this.toWorldFrame(ctx, input);
    drawFloor(ctx, world, colours, viewport.scale, false);
    toStartFrame(ctx, input.world);
    if (robot) drawStart(ctx, robot, colours, viewport.scale);
    if (this.strokeCtx) this.drawMarks(this.strokeCtx, input);
    this.drawFull(ctx, input);
    this.cost = performance.now() - before;
    this.drawnAt = now;
  }

  /** Marks lie above the path, which often leads over them. */
  private drawMarks(ctx: Ctx, input: CacheInput): void {
    this.toWorldFrame(ctx, input);
    toStartFrame(ctx, input.world);
    drawMarks(ctx, input.view.output.marks, input.colours);
  }

  private extend(ctx: Ctx, input: CacheInput): void {
    const { view } = input;
    const isFull =
      view.path.chunks.length === this.path.chunks &&
      view.idealPath.chunks.length === this.ideal.chunks &&
      view.output.strokes.length === this.strokes &&
      (view.output.pen?.trail.chunks.length ?? 0) <= this.pen.chunks;
    this.input = input;
    if (isFull) return;
    this.toWorldFrame(ctx, input);
    toStartFrame(ctx, input.world);
    this.drawFull(ctx, input);
  }

  private toWorldFrame(ctx: Ctx, { size, ratio }: CacheInput): void {
    const { viewport } = this;
    ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
    ctx.translate(size.width / 2 + MARGIN, size.height / 2 + MARGIN);
    ctx.scale(viewport.scale, -viewport.scale);
    ctx.translate(-viewport.x, -viewport.y);
  }

  /** Draws into the cache the chunks and strokes that were completed since the last call. */
  private drawFull(ctx: Ctx, input: CacheInput): void {
    const { view, colours } = input;
    const pixel = 1 / this.viewport.scale;
    this.ideal = drawnTo(ctx, view.idealPath, this.ideal, idealPen(colours, pixel));
    this.path = drawnTo(ctx, view.path, this.path, pathPen(colours, pixel));
    if (this.strokeCtx) this.drawFullStrokes(this.strokeCtx, input, pixel);
    this.input = input;
  }

  private drawFullStrokes(ctx: Ctx, input: CacheInput, pixel: number): void {
    const { view, colours } = input;
    this.toWorldFrame(ctx, input);
    toStartFrame(ctx, input.world);
    for (const stroke of view.output.strokes.slice(this.strokes)) {
      drawStroke(ctx, stroke, null, colours, pixel);
      this.pen = { chunks: 0, length: 0 };
    }
    this.strokes = view.output.strokes.length;
    const { pen } = view.output;
    if (pen) {
      drawStroke(ctx, restOf(pen, this.pen.chunks, false), null, colours, pixel);
      this.pen = { chunks: pen.trail.chunks.length, length: 0 };
    }
  }

  /** Draws the newest part of each path, which is not in the cache yet. The canvas is in the start frame. */
  drawPaths(ctx: Ctx, { view, colours }: CacheInput, viewport: Viewport, end: Point | null): void {
    const pixel = 1 / viewport.scale;
    drawRest(ctx, view.idealPath, this.ideal, idealPen(colours, pixel), null);
    drawRest(ctx, view.path, this.path, pathPen(colours, pixel), end);
  }

  /** Draws the part of the pen's unfinished stroke that is not in the cache yet. */
  drawPen(ctx: Ctx, { view, colours }: CacheInput, viewport: Viewport, end: Point | null): void {
    const { pen } = view.output;
    const pixel = 1 / viewport.scale;
    if (pen) drawStroke(ctx, restOf(pen, this.pen.chunks, true), end, colours, pixel);
  }
}

/** The part of a stroke after its drawn chunks, up to its last full chunk or its end. */
function restOf({ color, trail }: Stroke, drawn: number, toEnd: boolean): Stroke {
  const joint = trail.chunks[drawn - 1]?.slice(-JOINT) ?? [];
  const fresh = trail.chunks.slice(drawn);
  return { color, trail: { chunks: [joint, ...fresh], tail: toEnd ? trail.tail : [] } };
}

/** Points drawn twice where two parts of a stroke meet, so that the edge has no gap. */
const JOINT = 3;

interface Pen {
  readonly colour: string;
  readonly width: number;
  readonly dash: readonly number[];
}

const pathPen = (colours: Colours, pixel: number): Pen => ({
  colour: colours.path,
  width: 6 * pixel,
  dash: [],
});

/** The ideal path, drawn below the path, so that deviations of the robot are visible. */
const idealPen = (colours: Colours, pixel: number): Pen => ({
  colour: colours.ideal,
  width: 2 * pixel,
  dash: [5 * pixel, 6 * pixel],
});

function drawnTo(ctx: Ctx, trail: Trail, before: DrawnLength, pen: Pen): DrawnLength {
  const fresh = trail.chunks.slice(before.chunks);
  if (fresh.length === 0) return before;
  const joint = trail.chunks[before.chunks - 1]?.at(-1);
  applyPen(ctx, pen, before.length);
  ctx.beginPath();
  if (joint) ctx.moveTo(...joint);
  let [length, last] = [before.length, joint];
  for (const point of fresh.flat()) {
    ctx.lineTo(...point);
    if (last) length += Math.hypot(point[0] - last[0], point[1] - last[1]);
    last = point;
  }
  finish(ctx);
  return { chunks: trail.chunks.length, length };
}

function drawRest(ctx: Ctx, trail: Trail, before: DrawnLength, pen: Pen, end: Point | null): void {
  applyPen(ctx, pen, before.length);
  ctx.beginPath();
  const joint = trail.chunks[before.chunks - 1]?.at(-1);
  if (joint) ctx.moveTo(...joint);
  for (const chunk of trail.chunks.slice(before.chunks)) {
    for (const point of chunk) ctx.lineTo(...point);
  }
  for (const point of trail.tail) ctx.lineTo(...point);
  if (end) ctx.lineTo(...end);
  finish(ctx);
}

function applyPen(ctx: Ctx, { colour, width, dash }: Pen, offset: number): void {
  ctx.lineCap = dash.length > 0 ? "butt" : "round";
  ctx.lineJoin = "round";
  ctx.strokeStyle = colour;
  ctx.lineWidth = width;
  ctx.setLineDash([...dash]);
  ctx.lineDashOffset = offset;
}

function finish(ctx: Ctx): void {
  ctx.stroke();
  ctx.setLineDash([]);
  ctx.lineDashOffset = 0;
}

/**
 * Whether the second trail continues the drawn chunks of the first. Compares points by value: a
 * replay creates new arrays.
 */
export function begins(one: Trail, other: Trail, chunks: number): boolean {
  if (chunks === 0) return true;
  const [a, b] = [one.chunks[chunks - 1], other.chunks[chunks - 1]];
  return b !== undefined && (a === b || isSamePoint(a?.at(-1), b.at(-1)));
}

const isSamePoint = (one: Point | undefined, other: Point | undefined) =>
  one?.[0] === other?.[0] && one?.[1] === other?.[1];

function hasSameMarks({ marks: some }: Output, { marks: others }: Output): boolean {
  const [one, other] = [some.at(-1), others.at(-1)];
  const isSame = one?.symbol === other?.symbol && one?.x === other?.x && one?.y === other?.y;
  return some === others || (some.length === others.length && isSame);
}

/** Whether the stroke of this index is the same in both; replays create new ones. */
export function hasSameStroke(some: Output, others: Output, index: number): boolean {
  if (index < 0) return true;
  const [one, other] = [some.strokes[index], others.strokes[index]];
  if (!one || !other) return false;
  const isSame = isSamePoint(lastPoint(one.trail), lastPoint(other.trail));
  return one === other || (one.color === other.color && isSame);
}
