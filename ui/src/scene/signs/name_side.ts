import { points, type Trail } from "../../run/trail";
import { type StartPose, toWorld, type XY } from "../frames";
import { NAME_HEIGHT_PX, NAME_MAX_PX, type NameSide } from "./bubble_view";

/** The middle of a name on a side, in its own sizes from the robot's free circle; y up. */
const SIDES: Record<NameSide, XY> = {
  below: { x: 0, y: -1 },
  above: { x: 0, y: 1 },
  left: { x: -1, y: 0 },
  right: { x: 1, y: 0 },
};
const HALF: XY = { x: NAME_MAX_PX / 2, y: NAME_HEIGHT_PX / 2 };

/** The side on which a name covers least of the path; `reach` is free around the robot, in pixels. */
export function sideOfName(
  path: Trail,
  start: StartPose,
  robot: XY,
  reach: number,
  scale: number,
  sides: readonly NameSide[] = ["below", "above", "left", "right"],
): NameSide {
  const covered = sides.map(() => 0);
  for (const [x, y] of points(path)) {
    const point = toWorld(start, x, y);
    const [right, up] = [(point.x - robot.x) * scale, (point.y - robot.y) * scale];
    for (const [index, side] of sides.entries()) {
      const middle = { x: SIDES[side].x * (reach + HALF.x), y: SIDES[side].y * (reach + HALF.y) };
      const isOn = Math.abs(right - middle.x) < HALF.x && Math.abs(up - middle.y) < HALF.y;
      if (isOn) covered[index] = (covered[index] ?? 0) + 1;
    }
  }
  return sides[covered.indexOf(Math.min(...covered))] ?? "below";
}
