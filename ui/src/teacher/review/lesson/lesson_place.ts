import { type Signal, signal } from "@preact/signals";
import type { TimeOf } from "./lines";
import type { ScrollPlace } from "./scroll_place";

/** How a lesson's page was left: a replay is a step away and back. */
export interface LessonPlace extends ScrollPlace {
  readonly lesson: string;
  readonly timeOf: Signal<TimeOf>;
  /** Groups whose runs are shown in words. */
  readonly open: Signal<ReadonlySet<string>>;
}

let last: LessonPlace | null = null;

/** That of the lesson that was looked at last, for as long as the page is open; a new one for any other. */
export function placeOf(lesson: string): LessonPlace {
  if (last?.lesson !== lesson) {
    last = { lesson, timeOf: signal<TimeOf>("group"), open: signal(new Set<string>()), top: 0 };
  }
  return last;
}
