import { toWorld, type XY } from "./frames";

/**
 * A box, a zone or a painted area from above: metres and degrees, world frame. A disc if `radius`
 * is set, else a rectangle.
 */
export interface Area extends XY {
  readonly width: number;
  readonly depth: number;
  readonly heading: number;
  readonly radius: number | null;
}

/** Width of a drawn wall, metres. */
export const WALL_M = 0.09;

/** An area in the form of a world document. */
interface Written {
  readonly center: readonly number[];
  readonly size?: readonly number[] | null;
  readonly radius?: number | null;
  readonly heading_deg?: number;
}

export function areaOf({ center: [x = 0, y = 0], size, radius, heading_deg = 0 }: Written): Area {
  const side = 2 * (radius ?? 0);
  const [width = side, depth = side] = size ?? [];
  return { x, y, width, depth, heading: heading_deg, radius: radius ?? null };
}

/** Signs of x and y of a rectangle's corners in its own frame, in the order of `cornersOf`. */
export const CORNERS = [
  [-1, -1],
  [1, -1],
  [1, 1],
  [-1, 1],
] as const;

/** Corners of a rectangle, counterclockwise from the lower left in its own frame. */
export function cornersOf({ x, y, width, depth, heading }: Area): XY[] {
  const frame = { x, y, yaw: (heading * Math.PI) / 180 };
  return CORNERS.map(([right, up]) => toWorld(frame, (right * width) / 2, (up * depth) / 2));
}

/** Whether a point of the floor is in an area or on its edge. */
export function contains({ x, y, width, depth, heading, radius }: Area, point: XY): boolean {
  const [dx, dy] = [point.x - x, point.y - y];
  if (radius !== null) return Math.hypot(dx, dy) <= radius;
  const angle = (heading * Math.PI) / 180;
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return Math.abs(dx * cos + dy * sin) <= width / 2 && Math.abs(dy * cos - dx * sin) <= depth / 2;
}

/** Adds the outline of an area to the path of a canvas, in metres. */
export function trace(ctx: CanvasRenderingContext2D, area: Area): void {
  const { x, y, radius } = area;
  if (radius !== null) {
    ctx.moveTo(x + radius, y);
    ctx.arc(x, y, radius, 0, 2 * Math.PI);
    return;
  }
  const [first, ...others] = cornersOf(area) as [XY, ...XY[]];
  ctx.moveTo(first.x, first.y);
  for (const corner of others) ctx.lineTo(corner.x, corner.y);
  ctx.closePath();
}

/** The outline of an area as an SVG path, in pixels: `place` converts a point of the floor, `scale` is in pixels per metre. */
export function outlineOf(area: Area, place: (point: XY) => XY, scale: number): string {
  if (area.radius === null) return `${lineThrough(cornersOf(area).map(place))}Z`;
  const { x, y } = place(area);
  const r = area.radius * scale;
  return `M${x - r} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0Z`;
}

/** A line through points as an SVG path. */
export const lineThrough = (points: readonly XY[]) =>
  `M${points.map(({ x, y }) => `${x} ${y}`).join("L")}`;
