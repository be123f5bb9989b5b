import { computed, signal } from "@preact/signals";
import { type Route, route } from "../route";
import { teacherSession } from "./teacher_session";

export type ReviewOrigin = Extract<Route, { screen: "lesson" | "runs" }>;

/** Screens that a page of the review opens, directly or through another of these screens. */
const OPENED_FROM_REVIEW = [
  "replay",
  "versions",
  "differences",
  "compare",
  "presentation",
  "presentedprogram",
];

/** The review page from which `now` was opened; null after any other screen. */
export function nextOrigin(now: Route, last: ReviewOrigin | null): ReviewOrigin | null {
  if (now.screen === "lesson" || now.screen === "runs") return now;
  return OPENED_FROM_REVIEW.includes(now.screen) ? last : null;
}

const last = signal<ReviewOrigin | null>(null);
route.subscribe((now) => {
  last.value = nextOrigin(now, last.peek());
});

/** The review page to which the teacher can return; null for pupils and from other screens. */
export const reviewOrigin = computed(() => (teacherSession.value?.is_open ? last.value : null));
