import { expect, test } from "vitest";
import type { TruthSourceChangedEvent } from "../../api/model";
import { followedRun, receiveTruthSource, recordedTruths } from "./truth_sources";

const event = (change: Partial<TruthSourceChangedEvent>): TruthSourceChangedEvent => ({
  type: "truth_source",
  run: "r",
  source: "camera",
  state: "problem",
  code: null,
  message: "",
  remedy: "",
  ...change,
});
const covered = event({ code: "overhead_covered", message: "Coberto.", remedy: "Descubram." });

test("a problem is told while it lasts, and once after the run", () => {
  const followed = followedRun("r");
  receiveTruthSource(covered);
  expect(followed.value[0]?.problem).toBe("Coberto. Descubram.");
  receiveTruthSource(event({ state: "seeing" }));
  receiveTruthSource(covered);
  const before = recordedTruths.value;
  receiveTruthSource(event({ state: "recorded" }));
  expect(followed.value).toEqual([
    { run: "r", source: "camera", state: "recorded", problem: "", problems: ["Coberto."] },
  ]);
  expect(recordedTruths.value).toBe(before + 1);
});

test("problems of an earlier run are forgotten", () => {
  receiveTruthSource(covered);
  receiveTruthSource(event({ run: "s", state: "seeing" }));
  expect(followedRun("r").value).toEqual([]);
  expect(followedRun("s").value[0]?.problems).toEqual([]);
});
