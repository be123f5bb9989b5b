import { type Signal, signal } from "@preact/signals";
import type { ScrollPlace } from "../../../kit/scroll_place";
import type { TimeOf } from "../timeline/lines";

/** View state of a lesson's page, restored on return from a replay. */
export interface LessonPlace extends ScrollPlace {
  readonly lesson: string;
  readonly timeOf: Signal<TimeOf>;
  /** Groups whose runs are shown as text. */
  readonly open: Signal<ReadonlySet<string>>;
}

let last: LessonPlace | null = null;

/** The state of the last lesson only, for the lifetime of the page. */
export function placeOf(lesson: string): LessonPlace {
  if (last?.lesson !== lesson) {
    last = { lesson, timeOf: signal<TimeOf>("group"), open: signal(new Set<string>()), top: 0 };
  }
  return last;
}
