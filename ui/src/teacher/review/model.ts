import type { Figures, ReviewMark } from "../../api/model";

export type FigureName = keyof Figures;

/** How a run ended, as its mark shows it. */
export type Outcome = "passed" | "finished" | "notyet" | "stopped" | "failed" | "running";

/** How a run ended, as far as it is recorded. */
export interface Ended {
  readonly state: ReviewMark["state"];
  readonly passed: boolean | null;
}

/** A passed run counts as passed however it ended: it may be stopped once the goal is reached. */
export function outcomeOf({ state, passed }: Ended): Outcome {
  if (passed) return "passed";
  if (state === "finished" && passed === false) return "notyet";
  return state ?? "running";
}
