import { points, type Trail } from "../../run/trail";
import { type StartPose, toWorld, type XY } from "../frames";

/** About half of a name's width, and its height, in pixels. */
const HALF_PX = 70;
const HEIGHT_PX = 26;

/** Whether a name below the robot covers more of its path than one above it; `reach` is free around the robot, in pixels. */
export function isPathBelow(
  path: Trail,
  start: StartPose,
  robot: XY,
  reach: number,
  scale: number,
): boolean {
  let below = 0;
  for (const [x, y] of points(path)) {
    const point = toWorld(start, x, y);
    const up = (point.y - robot.y) * scale;
    const isBeside = Math.abs(point.x - robot.x) * scale > HALF_PX;
    if (isBeside || Math.abs(up) < reach || Math.abs(up) > reach + HEIGHT_PX) continue;
    below -= Math.sign(up);
  }
  return below > 0;
}
