import { expect, test } from "vitest";
import { clampedPart, DEFAULT_PART } from "./split";

test("both panes keep the width that they need", () => {
  for (const width of [1024, 1366, 1920]) {
    expect((clampedPart(0, width) / 100) * width).toBeCloseTo(420);
    expect((1 - clampedPart(100, width) / 100) * width).toBeCloseTo(360);
    expect(clampedPart(DEFAULT_PART, width)).toBe(DEFAULT_PART);
  }
});

test("in a window that is too narrow for both, the line is in the middle", () => {
  expect(clampedPart(20, 683)).toBe(50);
  expect(clampedPart(90, 683)).toBe(50);
});
