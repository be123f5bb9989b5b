import type { Colours } from "./colours";
import type { XY } from "./frames";
import type { Viewport } from "./viewport";

/** One path of many, world frame, metres. */
export interface BundlePath {
  readonly id: number;
  /** Whether it ended well: its end is a dot, else a cross. */
  readonly well: boolean;
  readonly path: readonly (readonly [x: number, y: number])[];
}

/** Paths of many robots on one floor. */
export interface Bundle {
  readonly paths: readonly BundlePath[];
  /** Whether they belong to an earlier program. */
  readonly isFaint: boolean;
}

const LINE_PX = 1.5;
const DOT_PX = 4;
const CROSS_PX = 5;

/** Draws the paths thin, those that ended well below the others, then the ends. The canvas is in the world frame. */
export function drawBundle(
  ctx: CanvasRenderingContext2D,
  { paths, isFaint }: Bundle,
  { scale }: Viewport,
  colours: Colours,
): void {
  const ordered = [...paths].sort((one, other) => Number(other.well) - Number(one.well));
  const pixel = 1 / scale;
  ctx.save();
  ctx.lineJoin = "round";
  ctx.lineWidth = LINE_PX * pixel;
  ctx.globalAlpha = isFaint ? 0.08 : 0.5;
  for (const { path, well } of ordered) {
    ctx.strokeStyle = well ? colours.path : colours.markX;
    ctx.setLineDash(well ? [] : [6 * pixel, 4 * pixel]);
    ctx.beginPath();
    for (const point of path) ctx.lineTo(...point);
    ctx.stroke();
  }
  ctx.setLineDash([]);
  ctx.globalAlpha = isFaint ? 0.25 : 1;
  for (const one of ordered) drawEnd(ctx, one, pixel, colours);
  ctx.restore();
}

/** Draws the end with a rim in the floor's colour, which separates it from paths and other ends. */
function drawEnd(
  ctx: CanvasRenderingContext2D,
  { path, well }: BundlePath,
  pixel: number,
  colours: Colours,
): void {
  const [x, y] = path.at(-1) ?? [Number.NaN, Number.NaN];
  ctx.beginPath();
  if (well) ctx.arc(x, y, DOT_PX * pixel, 0, 2 * Math.PI);
  else {
    const reach = CROSS_PX * pixel;
    for (const sign of [-1, 1]) {
      ctx.moveTo(x - reach, y - sign * reach);
      ctx.lineTo(x + reach, y + sign * reach);
    }
  }
  ctx.strokeStyle = colours.tile;
  ctx.lineWidth = (well ? 2 : 5) * pixel;
  ctx.stroke();
  if (well) {
    ctx.fillStyle = colours.path;
    ctx.fill();
  } else {
    ctx.strokeStyle = colours.markX;
    ctx.lineWidth = 2.5 * pixel;
    ctx.stroke();
  }
}

/** The path nearest to a point, by its end first; null if none comes within `reach`, metres. */
export function pathAt({ paths }: Bundle, at: XY, reach: number): BundlePath | null {
  return (
    nearest(paths, reach, ({ path }) => distanceTo(at, path.slice(-1))) ??
    nearest(paths, reach, ({ path }) => distanceTo(at, path))
  );
}

function nearest(
  paths: readonly BundlePath[],
  reach: number,
  distance: (one: BundlePath) => number,
): BundlePath | null {
  let best: BundlePath | null = null;
  let least = reach;
  for (const one of paths) {
    const found = distance(one);
    if (found > least) continue;
    best = one;
    least = found;
  }
  return best;
}

/** Distance of a point from a line of points, or from a single point. */
function distanceTo({ x, y }: XY, path: BundlePath["path"]): number {
  let least = Number.POSITIVE_INFINITY;
  for (const [index, [x1, y1]] of path.entries()) {
    const [x0, y0] = path[index - 1] ?? [x1, y1];
    const [dx, dy] = [x1 - x0, y1 - y0];
    const length = dx * dx + dy * dy;
    const part = length === 0 ? 0 : ((x - x0) * dx + (y - y0) * dy) / length;
    const at = Math.min(1, Math.max(0, part));
    least = Math.min(least, Math.hypot(x0 + at * dx - x, y0 + at * dy - y));
  }
  return least;
}
