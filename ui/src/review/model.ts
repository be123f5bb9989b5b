import type { components } from "../api/types";

type Schemas = components["schemas"];

export type LessonReview = Schemas["LessonReview"];
export type GroupReview = Schemas["GroupReview"];
export type GroupHead = Schemas["GroupHead"];
export type ReviewMark = Schemas["ReviewMark"];
export type ChangeCounts = Schemas["ChangeCounts"];
export type Figures = Schemas["Figures"];
export type FigureName = keyof Figures;
export type BlockCount = Schemas["BlockCount"];
export type HistoryRun = Schemas["HistoryRun"];
export type VersionDifference = Schemas["VersionDifference"];
export type BlockChange = Schemas["BlockChange"];

/** How a run ended, as its mark shows it. */
export type Outcome = "passed" | "finished" | "notyet" | "stopped" | "failed" | "running";

/** What is known of a run's end. */
export interface Ended {
  readonly state: ReviewMark["state"];
  readonly passed: boolean | null;
}

/** Passing comes before how it ended: a run may be stopped when the goal is reached. */
export function outcomeOf({ state, passed }: Ended): Outcome {
  if (passed) return "passed";
  if (state === "finished" && passed === false) return "notyet";
  return state ?? "running";
}
