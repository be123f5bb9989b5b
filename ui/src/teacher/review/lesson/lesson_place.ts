import { type Signal, signal } from "@preact/signals";
import type { ScrollPlace } from "../../../kit/scroll_place";
import type { TimeOf } from "../timeline/lines";

/** How the page of a lesson was left, for the way back from a replay. */
export interface LessonPlace extends ScrollPlace {
  readonly lesson: string;
  readonly timeOf: Signal<TimeOf>;
  /** Groups whose runs are shown in words. */
  readonly open: Signal<ReadonlySet<string>>;
}

let last: LessonPlace | null = null;

/** Remembered for the last lesson alone, and until the page is closed. */
export function placeOf(lesson: string): LessonPlace {
  if (last?.lesson !== lesson) {
    last = { lesson, timeOf: signal<TimeOf>("group"), open: signal(new Set<string>()), top: 0 };
  }
  return last;
}
