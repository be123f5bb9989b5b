import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { GROUP_COLORS, ROBOT_PATTERNS } from "../../api/declared";
import type { Colours } from "../colours";
import { contrast } from "../paints";
import { liveryOf, liveryPaint, MIN_CONTRAST, patternFrame } from "./livery";
import { PATTERNS, patternOf } from "./patterns";

const tokens = readFileSync("src/kit/tokens.css", "utf8");
const values = (token: string) =>
  [...tokens.matchAll(new RegExp(`${token}: ([^;]+);`, "g"))].map(([, value = ""]) => value);

/** The floor's colours of each theme, by the style sheet. */
const THEMES = ["light", "dark", "contrast"].map((theme, at) => {
  const token = (name: string) => values(`--${name}`)[at] ?? "";
  return [
    theme,
    {
      tile: token("floor-tile"),
      otherTile: token("floor-tile-other"),
      path: token("floor-path"),
      robot: token("robot-body"),
      deck: token("robot-deck"),
      mark: token("robot-mark") || "#ffffff",
      print: token("floor-print"),
    } as Colours,
  ] as const;
});
// a file may hold any colour
const COLOURS = [...GROUP_COLORS, "#ffffff", "#000000", "#808080", "#0a8a6c", "#ffe800"];
const livery = (colour: string, pattern = "waves") => ({ colour, pattern, name: "Faísca" });

test.each(THEMES)("in the theme %s every robot stands out from the floor", (_, colours) => {
  for (const colour of COLOURS) {
    const { body } = liveryPaint(livery(colour), colours);
    for (const ground of [colours.tile, colours.otherTile])
      expect(contrast(body, ground), `${colour} ${body}`).toBeGreaterThanOrEqual(MIN_CONTRAST);
  }
});

test.each(THEMES)("in the theme %s rim and arrow stand out from path and deck", (_, colours) => {
  expect(contrast(colours.tile, colours.path)).toBeGreaterThanOrEqual(MIN_CONTRAST);
  expect(contrast(colours.mark, colours.deck)).toBeGreaterThanOrEqual(MIN_CONTRAST);
});

test("a pattern differs from the body under it", () => {
  for (const [theme, colours] of THEMES.slice(0, 2)) {
    for (const colour of COLOURS) {
      const { body, pattern } = liveryPaint(livery(colour), colours);
      expect(contrast(body, pattern?.colour ?? body), `${theme} ${colour}`).toBeGreaterThan(2);
    }
  }
});

test("the colours of groups stay apart on every floor", () => {
  for (const [, colours] of THEMES.slice(0, 2)) {
    const bodies = GROUP_COLORS.map((colour) => liveryPaint(livery(colour), colours).body);
    expect(new Set(bodies).size).toBe(GROUP_COLORS.length);
  }
});

test("in high contrast, and without a group, the robot is as the theme draws it", () => {
  const contrastTheme = THEMES[2]?.[1] as Colours;
  const today = { body: contrastTheme.robot, pattern: null };
  expect(liveryPaint(livery("#1f6f8b"), contrastTheme)).toEqual(today);
  for (const [, colours] of THEMES)
    expect(liveryPaint(null, colours)).toEqual({ body: colours.robot, pattern: null });
});

test("each pattern of the store has a drawing; one of a newer release, or none, is plain", () => {
  expect(Object.keys(PATTERNS)).toEqual([...ROBOT_PATTERNS]);
  for (const name of ["plain", "", "tartan", "toString"]) expect(patternOf(name)).toBeNull();
  for (const name of ["waves", "stripes", "dots", "checks", "star"])
    expect(patternOf(name)?.path).toMatch(/^M/);
});

test("a robot without a name of its own has the name of its group", () => {
  const group = { name: "Botos", color: "#1f6f8b", robot_pattern: "waves", robot_name: "" };
  expect(liveryOf(group)?.name).toBe("Botos");
  expect(liveryOf({ ...group, robot_name: "Faísca" })?.name).toBe("Faísca");
  expect(liveryOf(null)).toBeNull();
});

test("the pattern covers the whole hull", () => {
  const hull_m: [number, number][] = [
    [0.3, -0.1],
    [0.3, 0.1],
    [-0.1, 0.1],
    [-0.1, -0.1],
  ];
  const { x, unit } = patternFrame({ hull_m });
  expect([x - unit, x + unit].map((one) => one.toFixed(3))).toEqual(["-0.100", "0.300"]);
});
