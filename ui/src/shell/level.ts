import { computed, signal } from "@preact/signals";
import type { Level } from "../blocks/definition";
import { texts } from "../i18n";
import { group } from "./session";
import { SettingById } from "./settings";

/** Levels of the toolbox, from few blocks to all. */
export const LEVELS = [1, 2, 3] as const satisfies readonly Level[];
const HIGHEST: Level = 3;

/** What the toolbox shows: a level, or only what the open mission offers. */
export type Shown = Level | "mission";

const ofGroups = new SettingById("pinel_levels");
const inMissions = new SettingById("pinel_mission_levels");

/** The level of the blocks that the open program had when it was opened. */
export const levelInUse = signal<Level>(1);

/** The level that is set for the class of the group; null where none is. */
export const levelOfClass = signal<Level | null>(null);

/** Where the group chose nothing: the lowest level that offers what its program has, or that of its class. */
const unchosen = computed(() => Math.max(levelInUse.value, levelOfClass.value ?? 1) as Level);

/** What each level is called in the language of the page. */
export function levelNames(): Readonly<Record<Level, string>> {
  const { first, explorer, everything } = texts.value.level;
  return { 1: first, 2: explorer, 3: everything };
}

/** The open mission, as far as the toolbox is concerned. */
export interface MissionLevel {
  /** Id of the program that is to solve it: what a group chooses holds for that. */
  readonly program: string;
  /** In which it opens; null for that of the group. */
  readonly level: Level | null;
  /** The actions that it offers; null for all of the level. */
  readonly blocks: readonly string[] | null;
}

/** Null without a mission. */
export const missionLevel = signal<MissionLevel | null>(null);

/** As chosen, otherwise what the mission says, otherwise the lowest level that offers what the program of the group has. */
export const shown = computed<Shown>(() => {
  const { value: mission } = missionLevel;
  if (!mission) return chosenIn(ofGroups, group.value?.id) ?? unchosen.value;
  const chosen = chosenIn(inMissions, mission.program);
  if (chosen !== undefined) return chosen;
  return mission.blocks ? "mission" : (mission.level ?? levelInUse.value);
});

/** The toolbox level. */
export const level = computed<Level>(() => {
  if (shown.value !== "mission") return shown.value;
  return missionLevel.value?.level ?? HIGHEST;
});

/** The actions that the toolbox is limited to; null for all blocks of the level. */
export const offered = computed(() =>
  shown.value === "mission" ? (missionLevel.value?.blocks ?? null) : null,
);

/** Keeps what the group chose: for the open mission, else for all its other programs. */
export function setLevel(chosen: Shown): void {
  const mission = missionLevel.peek();
  if (mission) inMissions.set(mission.program, chosen === "mission" ? null : String(chosen));
  else if (chosen !== "mission") ofGroups.set(group.peek()?.id ?? "", String(chosen));
}

function chosenIn(setting: SettingById, id = ""): Level | undefined {
  const chosen = setting.of(id);
  return LEVELS.find((one) => String(one) === chosen);
}
