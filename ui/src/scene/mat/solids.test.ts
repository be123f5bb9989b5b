import { describe, expect, test } from "vitest";
import { BOX_DRAWINGS, type BoxKind } from "./boxes";
import { BOX_SOLIDS, type Bodies, chestOf, crateOf, type Solid, wallOf } from "./solids";

const SIZES = [
  [0.5, 0.5],
  [1.6, 0.4],
  [0.4, 1.8],
  [4, 2],
  [0.05, 0.05],
] as const;

const PLAIN: Record<string, Bodies> = {
  "plain box": chestOf("#dcc9a6", "#b79f73"),
  "plain movable box": crateOf("#dcc9a6", "#b79f73"),
  wall: wallOf("#57503f"),
};

/** How far a body reaches from the centre, to both sides of one axis. */
function reachOf({ at, size, top = 1 }: Solid, axis: 0 | 1): [number, number] {
  const half = (size[axis] * Math.max(1, top)) / 2;
  return [at[axis] - half, at[axis] + half];
}

test("every thing of the floor has a form", () => {
  expect(Object.keys(BOX_SOLIDS).sort()).toEqual(Object.keys(BOX_DRAWINGS).sort());
});

describe.each([
  ...(Object.keys(BOX_SOLIDS) as BoxKind[]),
  ...Object.keys(PLAIN),
])("a %s", (kind) => {
  const bodies = PLAIN[kind] ?? BOX_SOLIDS[kind as BoxKind];

  test.each(
    SIZES,
  )("of %f m by %f m is a body where the robot is stopped, and nowhere else", (width, depth) => {
    const solids = bodies(width, depth);
    for (const [axis, size] of [
      [0, width],
      [1, depth],
    ] as const) {
      const reaches = solids.map((solid) => reachOf(solid, axis));
      expect(Math.min(...reaches.map(([low]) => low))).toBeCloseTo(-size / 2, 6);
      expect(Math.max(...reaches.map(([, high]) => high))).toBeCloseTo(size / 2, 6);
    }
  });

  test("rests on the floor, and is no taller than the camera above it needs", () => {
    for (const [width, depth] of SIZES) {
      const solids = bodies(width, depth);
      expect(Math.min(...solids.map(({ at }) => at[2]))).toBe(0);
      expect(Math.max(...solids.map(({ at, size }) => at[2] + size[2]))).toBeLessThan(1.3);
      expect(solids.every(({ size }) => Math.min(...size) > 0)).toBe(true);
    }
  });
});
