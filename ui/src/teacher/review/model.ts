import type { Figures, TimelineEntry } from "../../api/model";

export type MetricName = keyof Figures;

/** Outcome of a run, as its icon shows it. */
export type RunOutcome = "passed" | "finished" | "notyet" | "stopped" | "failed" | "running";

/** Recorded end of a run. */
export interface Ended {
  readonly state: TimelineEntry["state"];
  readonly passed: boolean | null;
  /** Title of its activity if it is none of the lesson's. */
  readonly other_mission?: string | null;
}

/**
 * A passed run counts as passed even if it was stopped after reaching the goal. Of another mission than the lesson's
 * only its end counts.
 */
export function outcomeOf({ state, passed, other_mission }: Ended): RunOutcome {
  if (other_mission) return state ?? "running";
  if (passed) return "passed";
  if (state === "finished" && passed === false) return "notyet";
  return state ?? "running";
}
