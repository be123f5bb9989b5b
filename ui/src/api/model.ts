import type {
  Event,
  GestureResultEvent,
  NewRun,
  NewVersion,
  SavedVersion,
  Setup,
  Status,
  Subscribe,
  World,
} from "./types";

/** Every object of the server's description, by its name there. */
export type * from "./types";

export type RunEvent = Event;
/** What a capture waits for: a sign, or a number shown by hand. */
export type CaptureOf = NonNullable<GestureResultEvent["what"]>;
export type Language = Status["language"];
/** Sensors around the robot that a page may subscribe to. */
export type Ring = Subscribe["sensors"][number];
/** State of the version that the page shows, after opening it and after saving it. */
export type SavedState = Pick<SavedVersion, "id" | "faults">;
/** How realistic the simulated robot is, and where its pose comes from: a camera or odometry. */
export type RealismOptions = Required<Pick<NewRun, "preset" | "feedback">>;
/** Options of a run that apply from its start: breakpoints, speed, steps, start pose, robot and seed. */
export type RunOptions = Omit<NewRun, "version_id" | "world">;
/** What the editor sends and the server stores; any object that JSON can hold. */
export interface EditorContent extends Pick<NewVersion, "parent_id"> {
  workspace: object;
  document: object | null;
  world?: World | null;
  setup?: Setup | null;
}

/** The name under which a run uses the version's own world. */
export const OWN_WORLD = "own";

/** A world's title: one text for all languages, or one per language; falls back to Portuguese. */
export function worldTitle({ title }: World, language: Language): string {
  return typeof title === "string" ? title : (title[language] ?? title["pt-BR"]);
}
