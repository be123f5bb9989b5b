import { describe, expect, test } from "vitest";
import type { FloorPlan } from "./plan";
import { fromStart, onFloor, reach } from "./start_frame";

const plan = (x: number, y: number, heading: number): FloorPlan => ({
  ...{ name: "own", title: null as never, width: 8, depth: 6, ground: null, objects: [] },
  start: { x, y, heading },
});

describe("a place has the numbers that the blocks use for it", () => {
  test("metres ahead of the start and to its left", () => {
    const { start } = plan(-3, -2, 90);
    expect(fromStart(start, { x: -3, y: -2 })).toEqual({ x: 0, y: 0 });
    expect(fromStart(start, { x: -3, y: 1 })).toEqual({ x: 3, y: 0 });
    expect(fromStart(start, { x: 1, y: -2 })).toEqual({ x: 0, y: -4 });
  });

  test("and back, whatever way the start looks", () => {
    for (const heading of [0, 30, 45, 90, -135]) {
      const { start } = plan(0.35, -1.2, heading);
      const counted = { x: 1.234, y: -0.5 };
      expect(fromStart(start, onFloor(start, counted))).toEqual(counted);
    }
  });

  test("as far as the floor goes", () => {
    expect(reach(plan(0, 0, 0), "x", 0.1)).toEqual({ min: -4, max: 4, step: 0.1 });
    expect(reach(plan(-3, -2, 0), "x", 0.1)).toEqual({ min: -1, max: 7, step: 0.1 });
    expect(reach(plan(-3, -2, 90), "x", 0.1)).toEqual({ min: -1, max: 5, step: 0.1 });
  });
});
