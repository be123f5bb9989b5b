import { expect, test } from "vitest";
import type { World } from "../api/model";
import { drawPaint } from "./ground";
import { paintOf } from "./paints";
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
