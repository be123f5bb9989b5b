import { afterEach, expect, test, vi } from "vitest";
import type { Run, RunPrediction } from "../api/model";
import { predictionsApi } from "../api/real_runs";
import { live, liveRun } from "../run/live";
import { IDLE } from "../run/reducer";
import { followPrediction, livePrediction } from "./live_prediction";

const show = (id: string, link: string) => {
  liveRun.value = { id, link } as Run;
  live.value = { ...IDLE, run: id, phase: "finished" };
};

afterEach(() => {
  liveRun.value = null;
  live.value = IDLE;
  vi.restoreAllMocks();
});

test("a prediction belongs to its run, also when the studio was left before the next one", async () => {
  const prediction = { awaits_input: false } as RunPrediction;
  vi.spyOn(predictionsApi, "of").mockResolvedValue(prediction);
  const stop = followPrediction();
  show("real", "bridge");
  await vi.waitFor(() => expect(livePrediction.value).toBe(prediction));
  stop();
  show("simulated", "sim");
  followPrediction()();
  expect(livePrediction.value).toBeNull();
});
