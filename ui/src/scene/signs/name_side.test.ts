import { expect, test } from "vitest";
import { EMPTY_TRAIL, extend, type Point, type Trail } from "../../run/trail";
import { isPathBelow } from "./name_side";

const [SCALE, REACH] = [50, 16];
const AT = { x: 0, y: 0 };
const EAST = { x: 0, y: 0, yaw: 0 };

/** A straight path to the robot, from a point. */
function pathFrom([x, y]: Point): Trail {
  let trail = EMPTY_TRAIL;
  for (let part = 100; part >= 0; part--)
    trail = extend(trail, [(x * part) / 100, (y * part) / 100]);
  return trail;
}

test("a name is above a robot that came from below, and below one that came from above or the side", () => {
  const from = (point: Point, start = EAST) =>
    isPathBelow(pathFrom(point), start, AT, REACH, SCALE);
  expect(from([0, -2])).toBe(true);
  expect(from([0.5, -2])).toBe(true);
  expect(from([0, 2])).toBe(false);
  expect(from([-2, 0])).toBe(false);
  expect(isPathBelow(EMPTY_TRAIL, EAST, AT, REACH, SCALE)).toBe(false);
  expect(from([-2, 0], { ...EAST, yaw: Math.PI / 2 })).toBe(true);
});

test("a path beside the name does not count", () => {
  const away: Trail = { chunks: [], tail: [[2, -0.5]] };
  expect(isPathBelow(away, EAST, AT, REACH, SCALE)).toBe(false);
});
