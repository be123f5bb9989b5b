import { computed, signal } from "@preact/signals";
import { type Route, route } from "./route";
import { door } from "./teacher";

export type ReviewPlace = Extract<Route, { screen: "lesson" | "runs" }>;

/** Screens from which a run or a version is looked at, and those that are about it. */
const ABOUT_IT = ["replay", "versions", "differences", "compare"];

/** Where the teacher came from: the way from there to this screen, without having been at anything else. */
export function nextPlace(now: Route, last: ReviewPlace | null): ReviewPlace | null {
  if (now.screen === "lesson" || now.screen === "runs") return now;
  return ABOUT_IT.includes(now.screen) ? last : null;
}

const last = signal<ReviewPlace | null>(null);
route.subscribe((now) => {
  last.value = nextPlace(now, last.peek());
});

/** The page of the review that the teacher can go back to; null for pupils, and for who came another way. */
export const reviewPlace = computed(() => (door.value?.is_open ? last.value : null));
