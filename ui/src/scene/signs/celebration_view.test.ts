import { expect, test } from "vitest";
import { CELEBRATION_MS, confetti } from "./celebration_view";

const ORIGIN = { x: 300, y: 200 };

test("the paper begins at the robot, spreads and falls, each time alike", () => {
  const begin = confetti(ORIGIN, 0, ["#111111", "#222222"]);
  expect(begin.every(({ x, y }) => x === ORIGIN.x && y === ORIGIN.y)).toBe(true);
  const middle = confetti(ORIGIN, 700, ["#111111", "#222222"]);
  expect(confetti(ORIGIN, 700, ["#111111", "#222222"])).toEqual(middle);
  const xs = middle.map(({ x }) => x - ORIGIN.x);
  expect(Math.min(...xs)).toBeLessThan(-60);
  expect(Math.max(...xs)).toBeGreaterThan(60);
  const mean = (pieces: typeof middle) => pieces.reduce((sum, { y }) => sum + y, 0) / pieces.length;
  expect(mean(confetti(ORIGIN, CELEBRATION_MS, ["#111111"]))).toBeGreaterThan(mean(middle));
});

test("the paper has all colours of the group", () => {
  const colours = ["#111111", "#222222", "#333333"];
  expect(new Set(confetti(ORIGIN, 100, colours).map((one) => one.colour))).toEqual(
    new Set(colours),
  );
});
