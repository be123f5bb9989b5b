import { readdirSync } from "node:fs";
import { cleanup, render } from "@testing-library/preact";
import { afterEach, expect, test } from "vitest";
import { contrast } from "../scene/paints";
import { StickerPicture } from "./StickerPicture";
import { DRAWN, drawingOf } from "./stickers";

const MISSIONS = readdirSync("../pinel_desktop/activities/catalogue");
const CHARACTER = ["repair", "shorter", "careful", "taught"];

afterEach(cleanup);

test("each shipped activity has a drawing of its own, and nothing else has", () => {
  expect([...DRAWN].sort()).toEqual(MISSIONS.sort());
});

test("no two stickers have the same drawing, nor the same shape and colour with it", () => {
  const drawings = [...DRAWN, ...CHARACTER].map((name) => JSON.stringify(drawingOf(name)));
  expect(new Set(drawings).size).toBe(drawings.length);
  for (const name of [...DRAWN, ...CHARACTER]) {
    const { marks, hands = [] } = drawingOf(name);
    expect(marks.length + hands.length).toBeGreaterThan(0);
    for (const { d } of marks) expect(d).toMatch(/^M[-\d]/);
  }
});

test("the white of a picture stands out on its sticker", () => {
  for (const name of [...DRAWN, ...CHARACTER, "an activity of a teacher"]) {
    expect(contrast("#ffffff", drawingOf(name).colour)).toBeGreaterThan(4);
  }
});

test("an empty place has the outline and the picture, but no colour", () => {
  const colours = (won: boolean) => {
    const { container } = render(<StickerPicture name="square" won={won} />);
    const found = container.innerHTML.match(/#[0-9a-f]{6}/g) ?? [];
    cleanup();
    return found;
  };
  expect(colours(true)).toContain(drawingOf("square").colour);
  expect(colours(false)).toEqual([]);
});
