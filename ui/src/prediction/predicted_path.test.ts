import { describe, expect, test } from "vitest";
import type { RunPrediction } from "../api/model";
import type { Stretch } from "../run/playback";
import { predictedPose, predictedTick, stepsOf } from "./predicted_path";

const step = (block: string, start: number, end: number | null) => ({
  pointer: `/${block}`,
  block,
  action: "turn",
  amount: 90,
  start,
  end,
});

const stretch = (block: string, from: number, to: number, amount: number | null = 90): Stretch => ({
  block,
  action: "turn",
  amount,
  from,
  to,
});

const PREDICTION: Pick<RunPrediction, "steps" | "path"> = {
  steps: [step("a", 0, 30), step("b", 40, 70)],
  path: [
    [0, 0, 0, 0],
    [30, 0, 0, Math.PI / 2],
    [70, 2, 1, Math.PI],
  ],
};

describe("the tick of a prediction", () => {
  test("is as long after the start of the same step, and the ghost waits at its end", () => {
    const real = [stretch("a", 6, 50), stretch("b", 52, 90)];
    const at = (tick: number) => predictedTick(PREDICTION, real, tick);
    expect(at(3)).toBe(0);
    expect(at(16)).toBe(10);
    expect(at(45)).toBe(30);
    expect(at(51)).toBe(30);
    expect(at(62)).toBe(50);
    expect(at(200)).toBe(70);
  });

  test("stays where the real run took another way", () => {
    const real = [stretch("a", 0, 40), stretch("c", 42, 90)];
    expect(predictedTick(PREDICTION, real, 60)).toBe(40);
  });

  test("waits at the end of a prediction that lacks an input", () => {
    const short = { ...PREDICTION, steps: PREDICTION.steps.slice(0, 1) };
    expect(predictedTick(short, [stretch("a", 0, 40), stretch("b", 60, 90)], 80)).toBe(70);
  });
});

test("blocks that take no time are no steps", () => {
  expect(
    stepsOf([stretch("say", 0, 1, null), stretch("a", 1, 2)]).map(({ block }) => block),
  ).toEqual(["a"]);
});

test("a pose of the prediction is interpolated", () => {
  const { path } = PREDICTION;
  expect(predictedPose(path, 15).yaw).toBeCloseTo(Math.PI / 4);
  expect(predictedPose(path, 50)).toMatchObject({ x: 1, y: 0.5 });
  expect(predictedPose(path, 99)).toMatchObject({ x: 2, y: 1 });
  expect(predictedPose([], 5)).toMatchObject({ x: 0, y: 0 });
});
