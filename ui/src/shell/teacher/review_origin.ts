import { computed, signal } from "@preact/signals";
import { type Route, route } from "../route";
import { teacherSession } from "./teacher_session";

export type ReviewOrigin = Extract<Route, { screen: "lesson" | "runs" }>;

/** Screens that a page of the review opens, and the ways on from them. */
const OPENED_FROM_REVIEW = ["replay", "versions", "differences", "compare"];

/** The review page that `now` was opened from; any other screen in between forgets it. */
export function nextOrigin(now: Route, last: ReviewOrigin | null): ReviewOrigin | null {
  if (now.screen === "lesson" || now.screen === "runs") return now;
  return OPENED_FROM_REVIEW.includes(now.screen) ? last : null;
}

const last = signal<ReviewOrigin | null>(null);
route.subscribe((now) => {
  last.value = nextOrigin(now, last.peek());
});

/** The page of the review that the teacher can go back to; null for pupils and for other ways here. */
export const reviewOrigin = computed(() => (teacherSession.value?.is_open ? last.value : null));
