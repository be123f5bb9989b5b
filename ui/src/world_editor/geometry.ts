import { CORNERS, cornersOf } from "../scene/areas";
import type { XY } from "../scene/frames";
import {
  type AreaObject,
  type FloorPlan,
  isArea,
  type Start,
  type Wall,
  type WorldObject,
} from "./plan";

/** Grid of drags, and the finer grid with Shift and for typed numbers; metres. */
export const GRID = 0.1;
export const FINE = 0.01;
const TURN_STEP = 15;
/** A wall's end snaps to another end within this distance. */
const END_M = 0.16;
/** A wall snaps to the horizontal or vertical within this angle. */
const STRAIGHT_DEG = 5;
export const MIN_SIZE_M = 0.1;
/** Radius of the largest robot, and minimum distance of the start from the outer walls, metres. */
const ROBOT_M = 0.3;

/** Rounds metres or degrees, to remove errors of binary fractions. */
export const clean = (value: number) => Math.round(value * 1000) / 1000 + 0;

export const snap = (value: number, step: number) => clean(Math.round(value / step) * step);

export const snapPoint = ({ x, y }: XY, step: number): XY => ({
  x: snap(x, step),
  y: snap(y, step),
});

export function insideRoom(plan: FloorPlan, { x, y }: XY, margin = 0): XY {
  const hold = (value: number, size: number) => {
    const limit = Math.max(0, size / 2 - margin);
    return Math.min(limit, Math.max(-limit, value));
  };
  return { x: hold(x, plan.width), y: hold(y, plan.depth) };
}

/** Snaps the end of a wall: to the end of another wall, to a straight line from its other end, or to the grid. */
export function snapEnd(
  plan: FloorPlan,
  point: XY,
  own: string,
  other: XY | null,
  free: boolean,
): XY {
  const held = insideRoom(plan, point);
  if (free) return snapPoint(held, FINE);
  const end = nearestEnd(plan, held, own);
  if (end) return end;
  return snapPoint(other ? straightened(held, other) : held, GRID);
}

function nearestEnd(plan: FloorPlan, point: XY, own: string): XY | null {
  let best: XY | null = null;
  let minDistance = END_M;
  for (const object of plan.objects) {
    if (object.kind !== "wall" || object.id === own) continue;
    for (const end of [object.from, object.to]) {
      const away = Math.hypot(end.x - point.x, end.y - point.y);
      if (away < minDistance) [best, minDistance] = [end, away];
    }
  }
  return best;
}

function straightened(point: XY, from: XY): XY {
  const slope = Math.tan((STRAIGHT_DEG * Math.PI) / 180);
  const [dx, dy] = [Math.abs(point.x - from.x), Math.abs(point.y - from.y)];
  if (dy < dx * slope) return { x: point.x, y: from.y };
  if (dx < dy * slope) return { x: from.x, y: point.y };
  return point;
}

/** The rectangle between two corners. */
export function between(one: XY, other: XY, free: boolean) {
  const step = free ? FINE : GRID;
  const [a, b] = [snapPoint(one, step), snapPoint(other, step)];
  return {
    x: clean((a.x + b.x) / 2),
    y: clean((a.y + b.y) / 2),
    width: clean(Math.abs(a.x - b.x)),
    depth: clean(Math.abs(a.y - b.y)),
  };
}

export const lengthOf = ({ from, to }: Wall) => Math.hypot(to.x - from.x, to.y - from.y);

/** The outermost points of an object. */
export function pointsOf(object: WorldObject): XY[] {
  if (!isArea(object)) return [object.from, object.to];
  if (object.radius === null) return cornersOf(object);
  const { x, y, radius } = object;
  return [
    { x: x - radius, y: y + radius },
    { x: x + radius, y: y - radius },
  ];
}

/** Shifts an object by metres, up to the edge of the floor. */
export function shifted<T extends WorldObject>(
  plan: FloorPlan,
  object: T,
  dx: number,
  dy: number,
): T {
  const points = pointsOf(object);
  const across = heldShift(
    points.map(({ x }) => x),
    dx,
    plan.width / 2,
  );
  const up = heldShift(
    points.map(({ y }) => y),
    dy,
    plan.depth / 2,
  );
  const move = ({ x, y }: XY): XY => ({ x: clean(x + across), y: clean(y + up) });
  if (isArea(object)) return { ...object, ...move(object) };
  return { ...object, from: move(object.from), to: move(object.to) };
}

function heldShift(values: readonly number[], shift: number, edge: number): number {
  const [min, max] = [Math.min(...values), Math.max(...values)];
  if (max - min > 2 * edge) return -(min + max) / 2;
  return Math.max(-edge - min, Math.min(edge - max, shift));
}

/** Rotates a vector of the world frame into the frame of an object with a `heading` in degrees. */
export function turnedBack({ x, y }: XY, heading: number): XY {
  return turnedBy({ x, y }, -heading);
}

export function turnedBy({ x, y }: XY, heading: number): XY {
  const angle = (heading * Math.PI) / 180;
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return { x: x * cos - y * sin, y: x * sin + y * cos };
}

/** Moves one corner to a point; the opposite corner stays. */
export function corneredTo(area: AreaObject, corner: number, point: XY, free: boolean): AreaObject {
  const step = free ? FINE : GRID;
  const still = cornersOf(area)[(corner + 2) % 4] ?? area;
  const reach = turnedBack({ x: point.x - still.x, y: point.y - still.y }, area.heading);
  const [right, up] = CORNERS[corner] ?? [1, 1];
  const width = Math.max(MIN_SIZE_M, snap(reach.x * right, step));
  const depth = Math.max(MIN_SIZE_M, snap(reach.y * up, step));
  const half = turnedBy({ x: (right * width) / 2, y: (up * depth) / 2 }, area.heading);
  return { ...area, width, depth, x: clean(still.x + half.x), y: clean(still.y + half.y) };
}

/** Sets the radius of a disc so that it reaches a point. */
export function reachingTo(area: AreaObject, point: XY, free: boolean): AreaObject {
  if (area.kind === "box" || area.kind === "print") return area;
  const away = Math.hypot(point.x - area.x, point.y - area.y);
  const radius = Math.max(MIN_SIZE_M, snap(away, free ? FINE : GRID));
  return { ...area, radius, width: 2 * radius, depth: 2 * radius };
}

/** Direction from a centre to a point in degrees, in (-180, 180]; 0 is right, 90 is up. */
export function headingTo(middle: XY, point: XY, free: boolean): number {
  const angle = (Math.atan2(point.y - middle.y, point.x - middle.x) * 180) / Math.PI;
  const snapped = snap(angle, free ? 1 : TURN_STEP);
  return snapped <= -180 ? 180 : snapped;
}

export const placed = (plan: FloorPlan, start: Start, point: XY, free: boolean): Start => ({
  ...start,
  ...snapPoint(insideRoom(plan, point, ROBOT_M), free ? FINE : GRID),
});
