import { computed } from "@preact/signals";
import { NO_CLASS } from "../api/classes";
import type { Classroom, Group } from "../api/model";
import { choose, setting } from "./settings";

const chosen = setting("pinel_class");

/** The class chosen last on this PC: an id, or NO_CLASS. */
export const classroom = computed(() => chosen.value || null);

export function setClassroom(id: string): void {
  void choose("pinel_class", id);
}

/**
 * The class to show: the class chosen last, else the class of the group used last, else the first.
 * NO_CLASS without classes.
 */
export function shownClass(
  lastChosen: string | null,
  classes: readonly Classroom[],
  groups: readonly Group[],
): string {
  const withNone = classes.length === 0 || groups.some((one) => !one.classroom_id);
  const known = [...classes.map(({ id }) => id), ...(withNone ? [NO_CLASS] : [])];
  if (lastChosen !== null && known.includes(lastChosen)) return lastChosen;
  return groups.find((one) => one.classroom_id)?.classroom_id ?? classes[0]?.id ?? NO_CLASS;
}

/** The groups of a class; with NO_CLASS the groups without a class. */
export function groupsIn(id: string, groups: readonly Group[]): Group[] {
  return groups.filter((one) => (one.classroom_id ?? NO_CLASS) === id);
}
