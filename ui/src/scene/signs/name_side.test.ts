import { expect, test } from "vitest";
import type { XY } from "../frames";
import { sideOfName } from "./name_side";

const SIZE = { width: 800, height: 600 };
const AT = { x: 400, y: 300 };

/** Points of the straight lines from a place to others. */
const lines = (from: XY, ...ends: readonly XY[]): XY[] =>
  ends.flatMap(({ x, y }) =>
    Array.from({ length: 101 }, (_, n) => ({
      x: from.x + ((x - from.x) * n) / 100,
      y: from.y + ((y - from.y) * n) / 100,
    })),
  );

const side = (path: readonly XY[], at = AT, size = SIZE) =>
  sideOfName(path, { at, reach: 16, size });

test("a name is where the path is not, first of all below", () => {
  const [left, down, up] = [
    { x: 300, y: 300 },
    { x: 400, y: 400 },
    { x: 400, y: 200 },
  ] as const;
  expect(side([])).toBe("below");
  expect(side(lines(AT, left))).toBe("below");
  expect(side(lines(AT, down))).toBe("above");
  expect(side(lines(AT, down, up))).toBe("left");
  expect(side(lines(AT, down, up, left))).toBe("right");
});

test("on a narrow floor without room beside the robot the name covers less of the path above it than below", () => {
  const size = { width: 316, height: 366 };
  const at = { x: 128, y: 180 };
  const bottom = lines({ x: 142, y: 204 }, { x: 194, y: 204 });
  expect(side([...bottom, ...lines(at, { x: 150, y: 130 })], at, size)).toBe("above");
});
