import { expect, test } from "vitest";
import type { World } from "../api/model";
import { textsOf } from "../i18n";
import { markText, placeAt } from "./mark_text";

const WORLD = {
  start: { x_m: -2, y_m: 1, heading_deg: 0 },
  zones: [
    { name: "A", center: [-1, 1], size: [1, 1], heading_deg: 0 },
    { name: "round", center: [1, 0], radius: 0.5 },
    { name: "tilted", center: [3, 0], size: [2, 0.2], heading_deg: 90 },
    { name: "on A", center: [-0.6, 1], size: [0.2, 0.2], heading_deg: 0 },
  ],
} as unknown as World;

test("a mark is told by its symbol and the place that it is in", () => {
  const texts = textsOf("pt-BR");
  expect(markText({ symbol: "X", x: 1, y: 0 }, WORLD, texts, "pt-BR")).toBe("X marcado em A");
  const outside = markText({ symbol: "O", x: 0, y: 0.5 }, WORLD, texts, "pt-BR");
  expect(outside.replaceAll("\u00a0", " ")).toBe("O marcado em x 0,00 m, y 0,50 m");
  expect(markText({ symbol: "X", x: 1, y: 0 }, null, texts, "pt-BR")).toContain("x 1,00");
});

test("places are found whatever their shape, the last one on top", () => {
  expect(placeAt(WORLD, { x: 1.3, y: 0.3 })).toBe("round");
  expect(placeAt(WORLD, { x: 1.4, y: 0.4 })).toBe("");
  expect(placeAt(WORLD, { x: 3.05, y: 0.9 })).toBe("tilted");
  expect(placeAt(WORLD, { x: 3.9, y: 0 })).toBe("");
  expect(placeAt(WORLD, { x: -0.6, y: 1 })).toBe("on A");
});
