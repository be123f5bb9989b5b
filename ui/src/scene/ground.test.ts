import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import type { World } from "../api/model";
import { drawPaint, drawZones } from "./ground";
import { contrast, paintOf } from "./paints";
import type { Palette } from "./palette";

const PALETTE = { tile: "#fafafa", number: "#202020" } as Palette;

/** Fill calls in order: the colour and the number of shapes in the path. */
function filled(floor: World["floor"]): [string, number][] {
  const fills: [string, number][] = [];
  let shapes = 0;
  const ctx = {
    fillStyle: "",
    beginPath: () => {
      shapes = 0;
    },
    moveTo: () => {
      shapes += 1;
    },
    lineTo: () => {},
    arc: () => {},
    closePath: () => {},
    stroke: () => {},
    fill() {
      fills.push([this.fillStyle, shapes]);
    },
  };
  drawPaint(
    ctx as unknown as CanvasRenderingContext2D,
    { floor } as unknown as World,
    PALETTE,
    0.01,
  );
  return fills;
}

const disc = (color: string) => ({ color, center: [0, 0] as [number, number], radius: 1 });
const square = (color: string) => ({
  color,
  center: [0, 0] as [number, number],
  size: [1, 1] as [number, number],
  heading_deg: 30,
});

test("areas of one colour that follow each other are one shape", () => {
  const fills = filled([disc("red"), square("red"), disc("blue"), disc("red")] as World["floor"]);
  expect(fills.filter(([color]) => color !== PALETTE.tile)).toEqual([
    [paintOf("red"), 2],
    [paintOf("blue"), 1],
    [paintOf("red"), 1],
  ]);
});

test("each colour hides what is below it", () => {
  const fills = filled([disc("red"), square("blue")] as World["floor"]);
  expect(fills.map(([color]) => color)).toEqual([
    PALETTE.tile,
    paintOf("red"),
    PALETTE.tile,
    paintOf("blue"),
  ]);
});

test("white is the bare floor, as the robot's sensor sees it", () => {
  expect(filled([disc("white")] as World["floor"])).toEqual([[PALETTE.tile, 1]]);
});

test("the name of an area can be read on each half-strength paint of the light theme", () => {
  const tokens = readFileSync("src/kit/tokens.css", "utf8");
  const [tile, ink] = ["--floor-tile", "--ink"].map(
    (token) => new RegExp(`${token}: (#[0-9a-f]{6})`).exec(tokens)?.[1] ?? "",
  ) as [string, string];
  const names: [string, number][] = [];
  const ctx = new Proxy({ fillStyle: "", globalAlpha: 1 } as Record<string, unknown>, {
    get: (own, key: string) => {
      if (key === "fillText")
        return () => names.push([String(own.fillStyle), Number(own.globalAlpha)]);
      if (key === "measureText") return () => ({ width: 1 });
      return own[key] ?? (() => {});
    },
  });
  const world = { zones: [{ ...square("red"), name: "meta" }] } as unknown as World;
  drawZones(ctx as unknown as CanvasRenderingContext2D, world, { tile, ink } as Palette, 0.01);
  expect(names).toEqual([[ink, 1]]);
  for (const paint of ["red", "orange", "yellow", "green", "blue", "purple", "white"]) {
    expect(contrast(ink, half(paintOf(paint), tile))).toBeGreaterThan(4.5);
  }
});

function half(one: string, other: string): string {
  const part = (text: string, at: number) => Number.parseInt(text.slice(at, at + 2), 16);
  const mixed = [1, 3, 5].map((at) => Math.round((part(one, at) + part(other, at)) / 2));
  return `#${mixed.map((value) => value.toString(16).padStart(2, "0")).join("")}`;
}
