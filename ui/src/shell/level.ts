import { computed, signal } from "@preact/signals";
import type { Level } from "../blocks/definition";
import { texts } from "../i18n";
import { group } from "./session";
import { SettingById } from "./settings";

/** Levels of the toolbox, from few blocks to all. */
export const LEVELS = [1, 2, 3] as const satisfies readonly Level[];
const HIGHEST: Level = 3;

/** The setting of the toolbox: a level, or only the actions that the open mission offers. */
export type ToolboxContent = Level | "mission";

const ofGroups = new SettingById("pinel_levels");
const inMissions = new SettingById("pinel_mission_levels");

/** The lowest level that offers all blocks that the open program had when it was opened. */
export const levelInUse = signal<Level>(1);

/** The level that the teacher set for the class of the group; null if none is set. */
export const levelOfClass = signal<Level | null>(null);

/** The level if the group chose none: the higher one of `levelInUse` and `levelOfClass`. */
const unchosen = computed(() => Math.max(levelInUse.value, levelOfClass.value ?? 1) as Level);

/** The names of the levels in the language of the page. */
export function levelNames(): Readonly<Record<Level, string>> {
  const { first, explorer, everything } = texts.value.level;
  return { 1: first, 2: explorer, 3: everything };
}

/** What the open mission sets for the toolbox. */
export interface MissionLevel {
  /** Id of the program that is to solve the mission: a group's choice applies to this program. */
  readonly program: string;
  /** The level in which the mission opens; null for the level of the group. */
  readonly level: Level | null;
  /** The actions that the mission offers; null for all actions of the level. */
  readonly blocks: readonly string[] | null;
}

/** What the open mission sets for the toolbox; null without a mission. */
export const missionLevel = signal<MissionLevel | null>(null);

/** The group's choice, else the setting of the mission, else a level that offers all blocks of the program. */
export const shown = computed<ToolboxContent>(() => {
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

/** Stores the group's choice: for the program of the open mission, else for all its other programs. */
export function setLevel(chosen: ToolboxContent): void {
  const mission = missionLevel.peek();
  if (mission) inMissions.set(mission.program, chosen === "mission" ? null : String(chosen));
  else if (chosen !== "mission") ofGroups.set(group.peek()?.id ?? "", String(chosen));
}

function chosenIn(setting: SettingById, id = ""): Level | undefined {
  const chosen = setting.of(id);
  return LEVELS.find((one) => String(one) === chosen);
}
