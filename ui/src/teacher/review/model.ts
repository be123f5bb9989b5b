import type { Figures, TimelineEntry } from "../../api/model";

export type MetricName = keyof Figures;

/** Outcome of a run, as its icon shows it. */
export type RunOutcome = "passed" | "finished" | "notyet" | "stopped" | "failed" | "running";

/** Recorded end of a run. */
export interface Ended {
  readonly state: TimelineEntry["state"];
  readonly passed: boolean | null;
}

/** A passed run counts as passed even if it was stopped after reaching the goal. */
export function outcomeOf({ state, passed }: Ended): RunOutcome {
  if (passed) return "passed";
  if (state === "finished" && passed === false) return "notyet";
  return state ?? "running";
}
