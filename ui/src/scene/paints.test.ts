import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { contrast, edgeOf, paintOf } from "./paints";

const NAMES = ["black", "red", "orange", "yellow", "green", "blue", "purple", "white"];

const tokens = readFileSync("src/kit/tokens.css", "utf8");
const values = (token: string) =>
  [...tokens.matchAll(new RegExp(`${token}: (#[0-9a-f]{6})`, "g"))].map(([, value = ""]) => value);

test.each(NAMES)("%s can be seen on the floor of every theme", (name) => {
  const grounds = values("--floor-tile");
  const inks = values("--floor-number");
  expect(grounds).toHaveLength(3);
  for (const [theme, ground] of grounds.entries()) {
    const paint = paintOf(name);
    const drawn = edgeOf(paint, ground, inks[theme] ?? "") ?? paint;
    expect(contrast(drawn, ground)).toBeGreaterThan(1.85);
  }
});

test("every name has a colour of its own", () => {
  expect(new Set(NAMES.map(paintOf)).size).toBe(NAMES.length);
  expect(paintOf("mauve")).toBe(paintOf("blue"));
});

test("contrast is that of WCAG", () => {
  expect(contrast("#ffffff", "#000000")).toBeCloseTo(21);
  expect(contrast("#777777", "#777777")).toBe(1);
});
