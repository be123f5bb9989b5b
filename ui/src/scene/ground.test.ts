import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import type { World } from "../api/model";
import { setLanguage } from "../i18n";
import type { Colours } from "./colours";
import { drawPaint, drawZones } from "./ground";
import { contrast, paintOf } from "./paints";

const COLOURS = { tile: "#fafafa", number: "#202020" } as Colours;

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
    COLOURS,
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
  expect(fills.filter(([color]) => color !== COLOURS.tile)).toEqual([
    [paintOf("red"), 2],
    [paintOf("blue"), 1],
    [paintOf("red"), 1],
  ]);
});

test("each colour hides what is below it", () => {
  const fills = filled([disc("red"), square("blue")] as World["floor"]);
  expect(fills.map(([color]) => color)).toEqual([
    COLOURS.tile,
    paintOf("red"),
    COLOURS.tile,
    paintOf("blue"),
  ]);
});

test("white is the bare floor, as the robot's sensor sees it", () => {
  expect(filled([disc("white")] as World["floor"])).toEqual([[COLOURS.tile, 1]]);
});

const tokens = readFileSync("src/kit/tokens.css", "utf8");
const values = (token: string) =>
  [...tokens.matchAll(new RegExp(`^  ${token}: (#[0-9a-f]{6})`, "gm"))].map(
    ([, value = ""]) => value,
  );
const [tiles, inks] = [values("--floor-tile"), values("--ink")];

test.each([
  "light",
  "dark",
  "contrast",
])("the name of an area can be read on any paint, %s", (name) => {
  expect([tiles.length, inks.length]).toEqual([3, 3]);
  const theme = ["light", "dark", "contrast"].indexOf(name);
  const [tile = "", ink = ""] = [tiles[theme], inks[theme]];
  const { letters, halos } = namesDrawn({ tile, ink } as Colours);
  expect(letters).toEqual([[ink, 1]]);
  // the letters have the colour of the bare floor around them, on any paint
  expect(halos).toEqual([[tile, 1]]);
  expect(contrast(ink, tile)).toBeGreaterThanOrEqual(4.5);
});

test("the name of a small area is as high as can be read, and does not meet the name beside", () => {
  const zone = (name: string, x: number, y = 0) => ({
    name,
    center: [x, y],
    size: [0.8, 0.8],
    radius: null,
  });
  // letters of 0.2 m each at their full height of 0.34 m; a pixel is 25 mm
  const heights = (...zones: object[]) => letterHeights(zones, 0.025);
  expect(heights(zone("A", 0))).toEqual([14]);
  expect(heights(zone("biblioteca", 0), zone("escola", 3))).toEqual([13, 13]);
  expect(heights(zone("biblioteca", 0), zone("escola", 0, 3))).toEqual([13, 13]);
  expect(heights(zone("biblioteca", 0), zone("escola", 1))).toEqual([5, 9]);
});

test("a place has its name in every language, and below it what that means", async () => {
  const lines = () => {
    const written: string[] = [];
    const ctx = new Proxy({} as Record<string, unknown>, {
      get: (_, key: string) => {
        if (key === "measureText") return () => ({ width: 20 });
        return (text: string) => key === "fillText" && written.push(text);
      },
      set: () => true,
    });
    const zones = [zoneNamed("padaria"), zoneNamed("A1")];
    const world = { zones } as unknown as World;
    drawZones(ctx as unknown as CanvasRenderingContext2D, world, COLOURS, 0.01);
    return written;
  };
  expect(lines()).toEqual(["padaria", "A1"]);
  await setLanguage("en");
  expect(lines()).toEqual(["padaria", "bakery", "A1"]);
  await setLanguage("pt-BR");
});

const zoneNamed = (name: string) => ({ name, center: [0, 0], size: [1, 1], radius: null });

/** Height in px of the letters of each name, rounded. */
function letterHeights(zones: object[], pixel: number): number[] {
  const found: number[] = [];
  let scale = 1;
  const ctx = {
    measureText: (text: string) => ({ width: 20 * text.length }),
    scale: (factor: number, y: number) => {
      if (y > 0) scale = factor;
    },
    fillText: () => found.push(Math.round((scale * 0.34) / pixel)),
  };
  const quiet = new Proxy(ctx as Record<string, unknown>, {
    get: (own, key: string) => own[key] ?? (() => {}),
  });
  const world = { zones } as unknown as World;
  drawZones(quiet as unknown as CanvasRenderingContext2D, world, COLOURS, pixel);
  return found;
}

/** Colour and opacity of the letters of an area's name, and of the halo drawn around them before. */
function namesDrawn(colours: Colours) {
  const letters: [string, number][] = [];
  const halos: [string, number][] = [];
  const ctx = new Proxy(
    { fillStyle: "", strokeStyle: "", globalAlpha: 1 } as Record<string, unknown>,
    {
      get: (own, key: string) => {
        const alpha = Number(own.globalAlpha);
        if (key === "fillText") return () => letters.push([String(own.fillStyle), alpha]);
        if (key === "strokeText") {
          return () => letters.length === 0 && halos.push([String(own.strokeStyle), alpha]);
        }
        if (key === "measureText") return () => ({ width: 1 });
        return own[key] ?? (() => {});
      },
    },
  );
  const world = { zones: [{ ...square("red"), name: "meta" }] } as unknown as World;
  drawZones(ctx as unknown as CanvasRenderingContext2D, world, colours, 0.01);
  return { letters, halos };
}
