import { signal } from "@preact/signals";
import type { Level } from "../blocks/definition";
import { remember, remembered } from "./remembered";

/** Levels of the toolbox, from few blocks to all. */
export const LEVELS = [1, 2, 3] as const satisfies readonly Level[];

const COOKIE = "pinel_level";

/** The toolbox level of this PC. */
export const level = signal<Level>(LEVELS.find((one) => String(one) === remembered(COOKIE)) ?? 3);

export function setLevel(chosen: Level): void {
  level.value = chosen;
  remember(COOKIE, String(chosen));
}
