import { computed, signal } from "@preact/signals";
import type { Level } from "../blocks/definition";
import { remember, remembered } from "./remembered";
import { group } from "./session";

/** Levels of the toolbox, from few blocks to all. */
export const LEVELS = [1, 2, 3] as const satisfies readonly Level[];

/** What each group chose on this PC, the newest choice first: "GROUP_LEVEL_GROUP_LEVEL". */
const COOKIE = "pinel_levels";
const MOST_GROUPS = 40;

type Choice = readonly [group: string, level: string];

const choices = signal<readonly Choice[]>(read(remembered(COOKIE) ?? ""));

/** The level of the blocks that the open program had when it was opened. */
export const levelInUse = signal<Level>(1);

/** As chosen, otherwise the lowest level that offers what the program of the group has. */
const ofThisGroup = computed<Level>(() => {
  const chosen = choices.value.find(([name]) => name === groupKey())?.[1];
  return LEVELS.find((one) => String(one) === chosen) ?? levelInUse.value;
});

/** The level of the open mission, which the group may change; null without a mission. */
export const missionLevel = signal<Level | null>(null);

/** The toolbox level: that of the mission, else that of the group. */
export const level = computed<Level>(() => missionLevel.value ?? ofThisGroup.value);

export function setLevel(chosen: Level): void {
  if (missionLevel.peek() !== null) missionLevel.value = chosen;
  else {
    const others = choices.value.filter(([name]) => name !== groupKey());
    choices.value = [[groupKey(), String(chosen)] as const, ...others].slice(0, MOST_GROUPS);
    remember(COOKIE, choices.value.flat().join("_"));
  }
}

/** The random end of the group's id. */
function groupKey(): string {
  return group.value?.id.slice(-12) ?? "";
}

function read(kept: string): Choice[] {
  const parts = kept ? kept.split("_") : [];
  return parts.flatMap((name, at) => (at % 2 ? [] : [[name, parts[at + 1] ?? ""] as const]));
}
