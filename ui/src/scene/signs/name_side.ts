import type { XY } from "../frames";
import { NAME_HEIGHT_PX, NAME_MAX_PX, type NameSide, nameAt, type RobotPlace } from "./bubble_view";

const HALF: XY = { x: NAME_MAX_PX / 2, y: NAME_HEIGHT_PX / 2 };

/** The side on which a name covers least of the path, whose points are in pixels of the canvas. */
export function sideOfName(
  path: Iterable<XY>,
  place: RobotPlace,
  sides: readonly NameSide[] = ["below", "above", "left", "right"],
): NameSide {
  const middles = sides.map((side) => nameAt(place, side, HALF.x));
  const covered = sides.map(() => 0);
  for (const { x, y } of path) {
    for (const [index, middle] of middles.entries()) {
      if (Math.abs(x - middle.x) < HALF.x && Math.abs(y - middle.y) < HALF.y)
        covered[index] = (covered[index] ?? 0) + 1;
    }
  }
  return sides[covered.indexOf(Math.min(...covered))] ?? "below";
}
