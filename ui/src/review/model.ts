import type { Lesson, Run } from "../api/model";

/** How many blocks differ between two versions. */
export interface ChangeCounts {
  added: number;
  removed: number;
  changed: number;
  moved: number;
}

/** A burst of edits or a run on the line of a group. */
export interface ReviewMark {
  kind: "edit" | "run";
  at: string;
  until?: string | null;
  program_id: string | null;
  program_name: string | null;
  version_id: string | null;
  n_edits?: number | null;
  changes?: ChangeCounts | null;
  since?: string | null;
  run_id?: string | null;
  state?: Run["state"] | null;
  reason?: string | null;
  message?: string | null;
  passed?: boolean | null;
  duration_s?: number | null;
  /** The failing run that this one made good. */
  repairs: string | null;
}

export interface Figures {
  n_edits: number;
  n_runs: number;
  n_failed: number;
  time_to_first_run_s: number | null;
  attempts_until_passed: number | null;
  active_s: number;
}

export type FigureName = keyof Figures;

export interface GroupFace {
  id: string;
  name: string;
  color: string;
  picture: string;
}

export interface GroupReview {
  group: GroupFace;
  marks: ReviewMark[];
  figures: Figures;
  blocks: { type: string; count: number }[];
}

export interface LessonReview {
  lesson: Lesson;
  groups: GroupReview[];
}
