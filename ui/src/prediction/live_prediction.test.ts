import { afterEach, expect, test, vi } from "vitest";
import type { Run, RunPrediction, TruthList } from "../api/model";
import { predictionsApi, truthsApi } from "../api/real_runs";
import { live, liveRun } from "../run/live";
import { IDLE } from "../run/reducer";
import { followPrediction, liveGhost, livePrediction } from "./live_prediction";

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

test("the path that the camera saw is shown when the run is over, and not in the next one", async () => {
  const poses = [0, 1].map((tick) => ({ tick, x_m: tick, y_m: 0 }));
  vi.spyOn(predictionsApi, "of").mockRejectedValue(new Error("none"));
  vi.spyOn(truthsApi, "of").mockResolvedValue({
    truths: [{ source: "camera", poses }],
  } as unknown as TruthList);
  const stop = followPrediction();
  show("filmed", "bridge");
  await vi.waitFor(() =>
    expect(liveGhost(null)?.measured).toEqual([
      [
        [0, 0],
        [1, 0],
      ],
    ]),
  );
  show("another", "bridge");
  expect(liveGhost(null)).toBeNull();
  stop();
});
