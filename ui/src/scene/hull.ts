import type { Robot } from "../api/model";
import type { XY } from "./frames";

type Hull = Pick<Robot, "hull_m" | "hull_round_m">;

/** Extents of the hull in the robot's frame, metres. */
export function extentOf({ hull_m }: Pick<Robot, "hull_m">) {
  const xs = hull_m.map(([x]) => x);
  const ys = hull_m.map(([, y]) => y);
  const [back, front] = [Math.min(...xs), Math.max(...xs)];
  const [right, left] = [Math.min(...ys), Math.max(...ys)];
  return { back, front, length: front - back, width: left - right };
}

/** A rounded corner of an outline: a quadratic curve from `into` to `out`, with `corner` as its control point. */
interface HullCorner {
  readonly into: XY;
  readonly corner: XY;
  readonly out: XY;
}

/** The corners of a robot from above: metres, x ahead, y to the left. */
export function hullCorners({ hull_m, hull_round_m }: Hull): HullCorner[] {
  const corners = hull_m.map(([x, y]) => ({ x, y }));
  return corners.map((corner, index) => {
    const before = corners.at(index - 1) ?? corner;
    const after = corners[(index + 1) % corners.length] ?? corner;
    return {
      into: towards(corner, before, hull_round_m),
      corner,
      out: towards(corner, after, hull_round_m),
    };
  });
}

/** Outline of a robot from above as the data of an SVG path: metres, x ahead, y to the left. */
export function hullPath(robot: Hull): string {
  const parts = hullCorners(robot).map(
    ({ into, corner, out }, index) => `${index ? "L" : "M"}${at(into)}Q${at(corner)} ${at(out)}`,
  );
  return `${parts.join("")}Z`;
}

/**
 * Moves a point towards the robot's centre until it lies on the outline. A point inside the outline
 * stays.
 */
export function onHull({ hull_m }: Pick<Robot, "hull_m">, { x, y }: XY): XY {
  const part = hull_m.reduce((nearest, [ax, ay], index) => {
    const [bx, by] = hull_m[(index + 1) % hull_m.length] ?? [ax, ay];
    const [dx, dy] = [bx - ax, by - ay];
    const across = x * dy - y * dx;
    const along = (ax * dy - ay * dx) / across;
    const aside = (ax * y - ay * x) / across;
    return along > 0 && aside >= 0 && aside <= 1 ? Math.min(nearest, along) : nearest;
  }, 1);
  return { x: x * part, y: y * part };
}

/** The point at `distance` from `from` towards `to`, at most halfway. */
function towards(from: XY, to: XY, distance: number): XY {
  const length = Math.hypot(to.x - from.x, to.y - from.y) || 1;
  const part = Math.min(0.5, distance / length);
  return { x: from.x + (to.x - from.x) * part, y: from.y + (to.y - from.y) * part };
}

const at = ({ x, y }: XY) => `${x.toFixed(4)} ${y.toFixed(4)}`;
