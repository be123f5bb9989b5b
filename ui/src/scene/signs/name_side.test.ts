import { expect, test } from "vitest";
import { EMPTY_TRAIL, extend, type Point } from "../../run/trail";
import { sideOfName } from "./name_side";

const [SCALE, REACH] = [50, 16];
const AT = { x: 0, y: 0 };
const EAST = { x: 0, y: 0, yaw: 0 };

/** The side of the name of a robot that came straight from some points. */
function side(from: readonly Point[], start = EAST): string {
  let trail = EMPTY_TRAIL;
  for (const [x, y] of from)
    for (let part = 100; part >= 0; part--)
      trail = extend(trail, [(x * part) / 100, (y * part) / 100]);
  return sideOfName(trail, start, AT, REACH, SCALE);
}

test("a name is where the path is not, first of all below", () => {
  expect(side([])).toBe("below");
  expect(side([[-2, 0]])).toBe("below");
  expect(side([[0, -2]])).toBe("above");
  const cross: Point[] = [
    [0, -2],
    [0, 2],
  ];
  expect(side(cross)).toBe("left");
  expect(side([...cross, [-2, 0]])).toBe("right");
});

test("the path is turned as its start is", () => {
  expect(side([[-2, 0]], { ...EAST, yaw: Math.PI / 2 })).toBe("above");
});
