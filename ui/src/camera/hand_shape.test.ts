import { describe, expect, test } from "vitest";
import { handShape, N_LANDMARKS } from "./hand_shape";
import signs from "./signs.json";

const { A, B } = signs;
const names = (sign: number[][]) => handShape(sign, "right").map(({ name }) => name);
const numbers = (path: string) => (path.match(/-?[\d.]+/g) ?? []).map(Number);

describe("the drawing of a hand", () => {
  test.each(Object.entries(signs))("has all its landmarks: %s", (_, sign) => {
    expect(sign).toHaveLength(N_LANDMARKS);
    for (const landmark of sign) expect(landmark).toHaveLength(3);
  });

  test.each(
    Object.entries(signs),
  )("stays in its square with the width of the fingers: %s", (_, sign) => {
    for (const side of ["left", "right"] as const) {
      for (const { path, width } of handShape(sign, side)) {
        expect(Math.min(...numbers(path)) - width / 2).toBeGreaterThan(0);
        expect(Math.max(...numbers(path)) + width / 2).toBeLessThan(100);
      }
    }
  });

  test("begins with what is farthest: the fingers of a fist lie over the palm, the thumb of B over it too", () => {
    expect(names(A).slice(0, 2)).toEqual(["thumb root", "palm"]);
    expect(names(B).slice(-2)).toEqual(["thumb", "thumb tip"]);
    const behind = A.map(([x, y, z = 0]) => [x, y, -z] as number[]);
    expect(names(behind).at(-1)).toBe("palm");
  });

  test.each(["B", "T", "V"] as const)("ends in a wrist, not in a tip: %s", (sign) => {
    const palm = handShape(signs[sign], "right").find(({ name }) => name === "palm");
    const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = numbers(palm?.path ?? "");
    expect(Math.hypot(x1 - x0, y1 - y0)).toBeGreaterThan((palm?.width ?? 0) / 2);
  });

  test("of a left hand is that of a right hand mirrored", () => {
    const [right, left] = [handShape(B, "right"), handShape(B, "left")];
    const xs = (path: string) => numbers(path).filter((_, index) => index % 2 === 0);
    left.forEach(({ path }, index) => {
      const mirrored = xs(right[index]?.path ?? "").map((x) => 100 - x);
      for (const [n, x] of xs(path).entries()) expect(x).toBeCloseTo(mirrored[n] ?? 0, 0);
    });
  });

  test("has a straight finger in one part, and the crease of a bent one between two", () => {
    expect(names(B)).not.toContain("tip 9");
    const tip = handShape(A, "right").find(({ name }) => name === "tip 9");
    expect(tip?.seam).toBeNull();
  });

  test("has one contour of palm and straight fingers: a finger's lines begin at the palm's rim", () => {
    expect(names(B).indexOf("finger 9 root")).toBeLessThan(names(B).indexOf("palm"));
    const finger = handShape(B, "right").find(({ name }) => name === "finger 9");
    const [, knuckle = 0] = numbers(finger?.path ?? "");
    const [, edge = 0] = numbers(finger?.edge ?? "");
    expect(edge).toBeLessThan(knuckle - 5);
  });
});
