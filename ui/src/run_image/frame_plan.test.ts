import { expect, test } from "vitest";
import { FRAMES_PER_S, MAX_PLAYED_S, planFrames } from "./frame_plan";

const TICKS_PER_S = 30;

test("a short run is shown at its own speed, ten pictures a second, from its start to its end", () => {
  const { ticks, speed } = planFrames(3 * TICKS_PER_S);
  expect(speed).toBe(1);
  expect(ticks).toHaveLength(3 * FRAMES_PER_S + 1);
  expect(ticks.slice(0, 3)).toEqual([0, 3, 6]);
  expect(ticks.at(-1)).toBe(90);
});

test.each([
  [MAX_PLAYED_S, 1],
  [MAX_PLAYED_S + 1, 2],
  [60, 4],
  [600, 64],
])("a run of %i s is shown %i times as fast, never longer than the limit", (run_s, expected) => {
  const { ticks, speed } = planFrames(run_s * TICKS_PER_S);
  expect(speed).toBe(expected);
  expect(ticks.length).toBeLessThanOrEqual(MAX_PLAYED_S * FRAMES_PER_S + 1);
  expect(ticks.at(-1)).toBe(run_s * TICKS_PER_S);
});

test("a run that stopped before its first tick is one picture", () => {
  expect(planFrames(0)).toEqual({ ticks: [0], speed: 1 });
});
