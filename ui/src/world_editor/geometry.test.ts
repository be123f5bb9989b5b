import { describe, expect, test } from "vitest";
import { cornersOf } from "../scene/areas";
import { corneredTo, headingTo, reachingTo, shifted, snap, snapEnd } from "./geometry";
import { type Box, type FloorPlan, type Paint, resized, type Wall } from "./plan";

const wall = (from: [number, number], to: [number, number], id = "w"): Wall => ({
  id,
  kind: "wall",
  from: { x: from[0], y: from[1] },
  to: { x: to[0], y: to[1] },
});

const box = (over: Partial<Box> = {}): Box => ({
  id: "b",
  kind: "box",
  x: 0,
  y: 0,
  width: 1,
  depth: 1,
  heading: 0,
  radius: null,
  movable: false,
  mass: null,
  boxKind: null,
  ...over,
});

const plan = (...objects: FloorPlan["objects"]): FloorPlan => ({
  name: "own",
  title: "",
  width: 8,
  depth: 6,
  ground: null,
  start: { x: 0, y: 0, heading: 0 },
  objects,
});

describe("a number on the grid", () => {
  test("has no dust of binary fractions", () => {
    expect(snap(0.3000000004, 0.1)).toBe(0.3);
    expect(snap(-0.04, 0.1)).toBe(0);
    expect(Object.is(snap(-0.04, 0.1), 0)).toBe(true);
    expect(snap(1.2345, 0.01)).toBe(1.23);
  });
});

describe("the end of a wall", () => {
  test("lies on the grid", () => {
    expect(snapEnd(plan(), { x: 1.04, y: -0.97 }, "w", null, false)).toEqual({ x: 1, y: -1 });
  });

  test("meets the end of another wall that is near, off the grid too", () => {
    const other = wall([1.234, 0], [3, 0], "other");
    expect(snapEnd(plan(other), { x: 1.3, y: 0.1 }, "w", null, false)).toEqual({ x: 1.234, y: 0 });
  });

  test("does not meet its own", () => {
    expect(snapEnd(plan(wall([1.234, 0], [3, 0])), { x: 1.22, y: 0 }, "w", null, false)).toEqual({
      x: 1.2,
      y: 0,
    });
  });

  test("makes a straight wall of one that is nearly so", () => {
    const other = { x: 0, y: 0.05 };
    expect(snapEnd(plan(), { x: 3, y: 0.26 }, "w", other, false)).toEqual({ x: 3, y: 0.1 });
    expect(snapEnd(plan(), { x: 3, y: 1 }, "w", other, false)).toEqual({ x: 3, y: 1 });
  });

  test("is free to the centimetre for who wants it so", () => {
    const other = wall([1.234, 0], [3, 0], "other");
    expect(snapEnd(plan(other), { x: 1.3, y: 0.056 }, "w", null, true)).toEqual({
      x: 1.3,
      y: 0.06,
    });
  });

  test("never leaves the floor", () => {
    expect(snapEnd(plan(), { x: 9, y: -9 }, "w", null, false)).toEqual({ x: 4, y: -3 });
  });
});

describe("a corner that is pulled", () => {
  test("leaves the opposite one where it is", () => {
    const pulled = corneredTo(box(), 2, { x: 1.52, y: 0.98 }, false);
    expect(pulled).toMatchObject({ x: 0.5, y: 0.25, width: 2, depth: 1.5 });
    expect(cornersOf(pulled)[0]).toEqual({ x: -0.5, y: -0.5 });
  });

  test("does so of a turned box", () => {
    const turned = box({ heading: 30 });
    const still = cornersOf(turned)[3];
    const pulled = corneredTo(turned, 1, { x: 2, y: -0.4 }, false);
    const [, , , after] = cornersOf(pulled);
    expect(after?.x).toBeCloseTo(still?.x ?? 0, 2);
    expect(after?.y).toBeCloseTo(still?.y ?? 0, 2);
    expect(pulled.width).toBeGreaterThan(1);
  });

  test("does not turn a thing inside out", () => {
    expect(corneredTo(box(), 2, { x: -3, y: -3 }, false)).toMatchObject({ width: 0.1, depth: 0.1 });
  });
});

test("a disc reaches to the hand", () => {
  const disc: Paint = { ...box(), kind: "paint", color: "red", radius: 0.5 };
  expect(reachingTo(disc, { x: 0.8, y: 0.6 }, false)).toMatchObject({ radius: 1, width: 2 });
});

describe("a heading", () => {
  test("is counted as the robot counts it", () => {
    const middle = { x: 1, y: 1 };
    expect(headingTo(middle, { x: 5, y: 1.1 }, false)).toBe(0);
    expect(headingTo(middle, { x: 1, y: 5 }, false)).toBe(90);
    expect(headingTo(middle, { x: -5, y: 0.9 }, false)).toBe(180);
    expect(headingTo(middle, { x: 1, y: -5 }, false)).toBe(-90);
  });

  test("comes in steps, or by degrees", () => {
    const point = { x: Math.cos(0.68), y: Math.sin(0.68) };
    expect(headingTo({ x: 0, y: 0 }, point, false)).toBe(45);
    expect(headingTo({ x: 0, y: 0 }, point, true)).toBe(39);
  });
});

test("what is moved stays on the floor", () => {
  expect(shifted(plan(), box(), 9, 0.5)).toMatchObject({ x: 3.5, y: 0.5 });
  expect(shifted(plan(), box({ heading: 45 }), -9, 0).x).toBeCloseTo(-4 + Math.SQRT1_2, 3);
  expect(shifted(plan(), wall([0, 0], [2, 0]), 9, 0)).toMatchObject({
    from: { x: 2, y: 0 },
    to: { x: 4, y: 0 },
  });
});

test("what has no room on the floor is put in its middle", () => {
  expect(shifted(plan(), box({ x: 1, width: 9 }), 1, 0)).toMatchObject({ x: 0, y: 0 });
});

test("the walls around a floor go with its size, those within stay", () => {
  const around = wall([-4, -3], [4, -3], "around");
  const within = wall([0, -3], [0, 1], "within");
  const { objects } = resized(plan(around, within), 10, 4);
  expect(objects).toEqual([{ ...around, from: { x: -5, y: -2 }, to: { x: 5, y: -2 } }, within]);
});
