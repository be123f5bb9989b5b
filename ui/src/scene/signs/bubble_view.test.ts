import { expect, test } from "vitest";
import { boxAt, type NameSide, nameAt } from "./bubble_view";

const BUBBLE = { width: 190, height: 62 };
const FLOORS = [
  { width: 548, height: 480 },
  { width: 272, height: 348 },
  { width: 400, height: 130 },
  { width: 660, height: 410 },
];

/** Places of the robot all over a floor, also at its edges. */
const places = (size: { width: number; height: number }) =>
  [0, 0.1, 0.5, 0.9, 1].flatMap((x) =>
    [0, 0.1, 0.5, 0.9, 1].map((y) => ({ x: x * size.width, y: y * size.height })),
  );

test.each(FLOORS)("wherever the robot is, its bubble is inside of a floor of %j", (size) => {
  for (const at of places(size)) {
    const { x, top, width, height } = boxAt({ at, reach: 24, size }, BUBBLE);
    expect(x - width / 2).toBeGreaterThanOrEqual(0);
    expect(x + width / 2).toBeLessThanOrEqual(size.width);
    expect(top).toBeGreaterThanOrEqual(0);
    expect(top + height).toBeLessThanOrEqual(size.height);
  }
});

test("a bubble is above the robot, below it under the controls, and left of the tools", () => {
  const [size] = FLOORS as [(typeof FLOORS)[number]];
  const at = (x: number, y: number) => boxAt({ at: { x, y }, reach: 24, size }, BUBBLE);
  const [middle, high] = [at(270, 300), at(270, 60)];
  expect(middle.top + middle.height).toBeLessThan(300 - 24);
  expect(high.top).toBeGreaterThan(60 + 24);
  expect(at(540, 300).x + BUBBLE.width / 2).toBe(size.width - 66);
  expect(middle.x).toBe(270);
});

test("a name is on the side that is wanted, but never under the controls or below the floor", () => {
  const [size] = FLOORS as [(typeof FLOORS)[number]];
  const at = (y: number, side: NameSide, x = 270) =>
    nameAt({ at: { x, y }, reach: 24, size }, side, 60);
  expect(at(300, "above").y).toBeLessThan(300);
  expect(at(300, "below").y).toBeGreaterThan(300);
  expect(at(84, "above").y).toBeGreaterThan(84);
  expect(at(470, "below").y).toBeLessThan(470);
  expect(at(300, "left")).toEqual({ x: 270 - 24 - 60 - 2, y: 300 });
  expect(at(300, "left", 70).y).toBeGreaterThan(300);
});
