import type { Language } from "../i18n/language";
import type { components } from "./types";

type Schemas = components["schemas"];

export type ActivityTitle = Schemas["ActivityTitle"];
export type Classroom = Schemas["Classroom"];
export type Computer = Schemas["Computer"];
export type Door = Schemas["Door"];
export type Fault = Schemas["Fault"];
export type Group = Schemas["Group"];
export type GroupChanges = Partial<Schemas["GroupChanges"]>;
export type Lesson = Schemas["Lesson"];
export type LessonChanges = Partial<Schemas["LessonChanges"]>;
export type NewGroup = Pick<Schemas["NewGroup"], "name"> & Partial<Schemas["NewGroup"]>;
export type NewLesson = Pick<Schemas["NewLesson"], "title"> & Partial<Schemas["NewLesson"]>;
export type Note = Schemas["Note"];
export type Notice = Schemas["Notice"];
export type Program = Schemas["Program"];
export type ProgramWithVersion = Schemas["ProgramWithVersion"];
export type ReadPython = Schemas["ReadPython"];
export type Run = Schemas["Run"];
export type RunList = Schemas["RunList"];
export type RunWithVersion = Schemas["RunWithVersion"];
export type ProgramEvent = Schemas["ProgramEvent"];
export type SavedVersion = Schemas["SavedVersion"];
/** What the page has to know of the version it shows, whether it was opened or saved. */
export type OnDisk = Pick<SavedVersion, "id" | "faults">;
export type Status = Schemas["Status"];
export type World = Schemas["World"];
export type WrittenPython = Schemas["WrittenPython"];
export type RunEvent = Schemas["Event"];
export type TelemetryEvent = Schemas["TelemetryEvent"];
export type RunEndedEvent = Schemas["RunEndedEvent"];
export type StreamEvent = Schemas["StreamEvent"];
export type JudgedEvent = Schemas["JudgedEvent"];
export type Evaluated = Schemas["Evaluated"];
export type StepMode = Schemas["Step"]["mode"];
export type RangesEvent = Schemas["RangesEvent"];
/** Where a robot begins: metres and degrees, world frame. */
export type Start = World["start"];
/** Sensors around the robot that somebody may look at. */
export type Ring = Schemas["Look"]["sensors"][number];
type NewRun = Schemas["NewRun"];
/** How true to life a run is, and what the robot knows of its place. */
export type Lifelike = Pick<NewRun, "preset" | "feedback">;
/** What a run is to know of breakpoints, speed, steps, start and surroundings from its beginning. */
export type Debugging = Partial<
  Pick<NewRun, "breakpoints" | "speed" | "paused" | "start" | keyof Lifelike>
>;
export type ErrorBody = Schemas["ErrorBody"];

/** What the editor hands over and the server keeps. */
export interface Content {
  workspace: object;
  document: object | null;
  /** A world of the group's own, null where the program runs in one chosen by name. */
  world?: World | null;
  /** The version that was edited; the newest where it is not told. */
  parent_id?: string;
}

/** The name under which a version's own world is run in. */
export const OWN_WORLD = "own";

/** A world's title: one text, or one in each language. */
export function worldTitle({ title }: World, language: Language): string {
  return typeof title === "string" ? title : title[language];
}
