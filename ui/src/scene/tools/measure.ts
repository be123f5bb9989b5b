import type { XY } from "../frames";

/** Tools that measure on the floor. */
export type MeasureTool = "ruler" | "protractor";

/** Number of points of each tool: two ends; a vertex and a point on each ray. */
export const POINTS_OF: Readonly<Record<MeasureTool, number>> = { ruler: 2, protractor: 3 };

export type Measured =
  | { readonly kind: "distance"; readonly metres: number }
  | { readonly kind: "angle"; readonly degrees: number };

/** Measures the points of a tool: a distance, or the angle from the first ray to the second, positive to the left. */
export function measured(tool: MeasureTool, points: readonly XY[]): Measured | null {
  const [a, b, c] = points;
  if (tool === "ruler") return a && b ? { kind: "distance", metres: distance(a, b) } : null;
  return a && b && c ? { kind: "angle", degrees: turnBetween(a, b, c) } : null;
}

export const distance = (a: XY, b: XY) => Math.hypot(b.x - a.x, b.y - a.y);

/** Angle in degrees, in (-180, 180], from the ray through `from` to the ray through `to`. */
export function turnBetween(corner: XY, from: XY, to: XY): number {
  const [ax, ay] = [from.x - corner.x, from.y - corner.y];
  const [bx, by] = [to.x - corner.x, to.y - corner.y];
  const turn = (Math.atan2(ax * by - ay * bx, ax * bx + ay * by) * 180) / Math.PI;
  return turn <= -180 ? turn + 360 : turn;
}

/** The nearest snap point within `reach`, else the point itself. */
export function snapped(point: XY, places: readonly XY[], reach: number): XY {
  let [best, minDistance] = [point, reach];
  for (const place of places) {
    const far = distance(place, point);
    if (far < minDistance) [best, minDistance] = [place, far];
  }
  return best;
}

const STEP_M = 0.1;
const STEP_DEG = 15;

/** Rounds to the grid of start poses: 0.1 m, and for angles 15 degrees. */
export const onGrid = (metres: number) => Math.round(metres / STEP_M) / (1 / STEP_M);
export const onTurn = (degrees: number) => Math.round(degrees / STEP_DEG) * STEP_DEG;

/** Wraps degrees to (-180, 180]. */
export function turned(degrees: number): number {
  const rest = degrees - 360 * Math.ceil((degrees - 180) / 360);
  return rest === 0 ? 0 : rest;
}
