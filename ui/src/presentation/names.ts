import { computed } from "@preact/signals";
import type { Group } from "../api/model";
import type { Texts } from "../i18n";
import { type Livery, liveryOf } from "../scene/livery/livery";
import { choose, setting } from "../shell/settings";

const NAME = "pinel_projector_names";
const chosen = setting(NAME);

/** Whether groups have letters in place of their names. Stays on this PC. */
export const isNameless = computed(() => chosen.value === "hidden");

export function toggleNames(): void {
  void choose(NAME, isNameless.peek() ? "shown" : "hidden");
}

/** What is shown of a group. */
export interface ShownGroup {
  readonly name: string;
  readonly picture: string | null;
  readonly colour: string | null;
  readonly livery: Livery | null;
}

const LETTERS = ["A", "B"] as const;

/** The group at a place; without its name, picture and robot's name if they are hidden. */
export function shownGroup(
  groupId: string | null,
  place: number,
  groups: readonly Group[],
  { projector, review }: Texts,
): ShownGroup {
  const group = groups.find(({ id }) => id === groupId);
  const livery = liveryOf(group);
  if (isNameless.value) {
    const name = projector.group({ letter: LETTERS[place] ?? "" });
    return { name, picture: null, colour: null, livery: livery && { ...livery, name: "" } };
  }
  const name = group?.name ?? review.runs.commandLine;
  return { name, picture: group?.picture ?? null, colour: group?.color ?? null, livery };
}
