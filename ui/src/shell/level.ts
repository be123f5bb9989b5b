import { computed, signal } from "@preact/signals";
import type { Level } from "../blocks/definition";
import { remember, remembered } from "./remembered";

/** Levels of the toolbox, from few blocks to all. */
export const LEVELS = [1, 2, 3] as const satisfies readonly Level[];

const COOKIE = "pinel_level";

const ofThisPc = signal<Level>(LEVELS.find((one) => String(one) === remembered(COOKIE)) ?? 3);

/** The level of the open mission, which the group may change; null without a mission. */
export const missionLevel = signal<Level | null>(null);

/** The toolbox level: that of the mission, else that of this PC. */
export const level = computed<Level>(() => missionLevel.value ?? ofThisPc.value);

export function setLevel(chosen: Level): void {
  if (missionLevel.peek() !== null) missionLevel.value = chosen;
  else {
    ofThisPc.value = chosen;
    remember(COOKIE, String(chosen));
  }
}
