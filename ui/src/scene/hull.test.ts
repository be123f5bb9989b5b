import { expect, test } from "vitest";
import { extentOf, hullPath, onHull } from "./hull";

const box = {
  hull_m: [
    [0.2, -0.1],
    [0.2, 0.1],
    [-0.1, 0.1],
    [-0.1, -0.1],
  ] as [number, number][],
  hull_round_m: 0.05,
};

test("the outline has a curve at each corner of the hull, and no more", () => {
  expect(hullPath(box)).toBe(
    "M0.1500 -0.1000Q0.2000 -0.1000 0.2000 -0.0500L0.2000 0.0500Q0.2000 0.1000 0.1500 0.1000" +
      "L-0.0500 0.1000Q-0.1000 0.1000 -0.1000 0.0500L-0.1000 -0.0500Q-0.1000 -0.1000 -0.0500 -0.1000Z",
  );
});

test("corners are rounded along half of their sides at most", () => {
  expect(hullPath({ ...box, hull_round_m: 9 })).toMatch(/^M0.0500 -0.1000Q.* 0.2000 0.0000L/);
});

test("the extent of a hull is that of its corners", () => {
  const { back, front, length, width } = extentOf(box);
  expect([back, front]).toEqual([-0.1, 0.2]);
  expect(length).toBeCloseTo(0.3);
  expect(width).toBeCloseTo(0.2);
});

test("a place outside of the hull is drawn on it, one inside where it is", () => {
  expect(onHull(box, { x: 0.4, y: 0 })).toEqual({ x: 0.2, y: 0 });
  expect(onHull(box, { x: 0.2, y: 0.2 })).toEqual({ x: 0.1, y: 0.1 });
  expect(onHull(box, { x: 0.1, y: 0 })).toEqual({ x: 0.1, y: 0 });
});
