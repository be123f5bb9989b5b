import { describe, expect, test } from "vitest";
import { BOX_DRAWINGS, type BoxKind } from "./boxes";
import type { Part } from "./parts";

interface Bounds {
  left: number;
  right: number;
  bottom: number;
  top: number;
}

/** What a shape covers, its line included. Knows the commands that the drawings use. */
function boundsOf({ d, line, width = 0 }: Part): Bounds {
  const box = { left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity };
  const reach = line ? width / 2 : 0;
  let [x, y] = [0, 0];
  const include = (px: number, py: number) => {
    box.left = Math.min(box.left, px - reach);
    box.right = Math.max(box.right, px + reach);
    box.bottom = Math.min(box.bottom, py - reach);
    box.top = Math.max(box.top, py + reach);
  };
  for (const [, command = "", rest = ""] of d.matchAll(/([MLHVaZ])([^MLHVaZ]*)/g)) {
    const n = (rest.match(/-?[\d.]+(?:e-?\d+)?/g) ?? []).map(Number);
    const [a = 0, b = 0] = n;
    if (command === "M" || command === "L") [x, y] = [a, b];
    else if (command === "H") x = a;
    else if (command === "V") y = a;
    else if (command === "a") {
      const [dx = 0, dy = 0] = n.slice(5);
      if (n[3] === 1) {
        include(x + dx / 2, y + b);
        include(x + dx / 2, y - b);
      }
      [x, y] = [x + dx, y + dy];
    } else if (command !== "Z") throw new Error(`unknown command ${command}`);
    if (command !== "Z") include(x, y);
  }
  return box;
}

const SIZES = [
  [0.5, 0.5],
  [1.6, 0.4],
  [0.4, 1.8],
  [0.05, 0.05],
] as const;

describe.each(Object.keys(BOX_DRAWINGS) as BoxKind[])("a %s", (kind) => {
  test.each(SIZES)("of %f m by %f m covers what stops the robot, and no more", (width, depth) => {
    const parts = BOX_DRAWINGS[kind](width, depth, "").map(boundsOf);
    const all = {
      left: Math.min(...parts.map(({ left }) => left)),
      right: Math.max(...parts.map(({ right }) => right)),
      bottom: Math.min(...parts.map(({ bottom }) => bottom)),
      top: Math.max(...parts.map(({ top }) => top)),
    };
    expect(all.left).toBeCloseTo(-width / 2, 6);
    expect(all.right).toBeCloseTo(width / 2, 6);
    expect(all.bottom).toBeCloseTo(-depth / 2, 6);
    expect(all.top).toBeCloseTo(depth / 2, 6);
  });
});
