import { type Signal, signal } from "@preact/signals";
import type { ScrollPosition } from "../../../kit/scroll_position";
import type { TimeOf } from "../timeline/timelines";

/** View state of a lesson's page, restored on return from a replay. */
export interface LessonViewState extends ScrollPosition {
  readonly lesson: string;
  readonly timeOf: Signal<TimeOf>;
  /** Groups whose runs are shown as text. */
  readonly open: Signal<ReadonlySet<string>>;
}

let last: LessonViewState | null = null;

/** The state of the last lesson only, for the lifetime of the page. */
export function viewStateOf(lesson: string): LessonViewState {
  if (last?.lesson !== lesson) {
    last = { lesson, timeOf: signal<TimeOf>("group"), open: signal(new Set<string>()), top: 0 };
  }
  return last;
}
