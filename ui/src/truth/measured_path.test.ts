import { expect, test } from "vitest";
import type { Truth } from "../api/model";
import { measuredPieces, sourceOfPath } from "./measured_path";

const pose = (tick: number | null, x_m: number) => ({
  tick,
  x_m,
  y_m: 0,
  heading_rad: 0,
  sigma_m: 0.01,
  sigma_rad: 0.01,
});
const truth = (source: Truth["source"], ...ticks: (number | null)[]): Truth => ({
  source,
  measured_at: "",
  covered_s: 0,
  poses: ticks.map((tick) => pose(tick, tick ?? 99)),
});
const list = (...truths: Truth[]) => ({ truths, believed: null, run_s: 1 });

test("a path has a gap where the source saw nothing for half a second, and no end that was measured later", () => {
  const pieces = measuredPieces(truth("camera", 0, 15, 31, 32, null));
  expect(pieces.map((piece) => piece.map(([x]) => x))).toEqual([
    [0, 15],
    [31, 32],
  ]);
});

test("the camera's path counts before that of the localisation; a tape has none", () => {
  const camera = truth("camera", 0, 1);
  const own = truth("localisation", 0, 1);
  expect(sourceOfPath(list(own, truth("tape", null), camera))).toBe(camera);
  expect(sourceOfPath(list(own, truth("camera", 3)))).toBe(own);
  expect(sourceOfPath(list(truth("tape", null)))).toBeUndefined();
});
