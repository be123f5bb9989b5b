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
    expect(names(A)[0]).toBe("palm");
    expect(names(B).slice(-2)).toEqual(["thumb", "thumb tip"]);
    const behind = A.map(([x, y, z = 0]) => [x, y, -z] as number[]);
    expect(names(behind).at(-1)).toBe("palm");
  });

  test("of a left hand is that of a right hand mirrored", () => {
    const [right, left] = [handShape(B, "right"), handShape(B, "left")];
    const xs = (path: string) => numbers(path).filter((_, index) => index % 2 === 0);
    left.forEach(({ path }, index) => {
      const mirrored = xs(right[index]?.path ?? "").map((x) => 100 - x);
      for (const [n, x] of xs(path).entries()) expect(x).toBeCloseTo(mirrored[n] ?? 0, 0);
    });
  });

  test("hides the seam of a straight finger and shows the crease of a bent one", () => {
    const tip = (sign: number[][]) =>
      handShape(sign, "right").find(({ name }) => name === "tip 9")?.seam;
    expect(tip(B)).not.toBeNull();
    expect(tip(A)).toBeNull();
  });
});
