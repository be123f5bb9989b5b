import type {
  Event,
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
export type Language = Status["language"];
/** Sensors around the robot that a page may subscribe to. */
export type Ring = Subscribe["sensors"][number];
/** What the page has to know of the version it shows, whether it was opened or saved. */
export type SavedState = Pick<SavedVersion, "id" | "faults">;
/** How true to life a run is, and what the robot knows of its place. */
export type RealismOptions = Required<Pick<NewRun, "preset" | "feedback">>;
/** What a run is to know of breakpoints, speed, steps, start and robot from its beginning. */
export type RunOptions = Omit<NewRun, "version_id" | "world" | "seed">;
/** What the editor hands over and the server keeps; of any object JSON can be made. */
export interface EditorContent extends Pick<NewVersion, "parent_id"> {
  workspace: object;
  document: object | null;
  world?: World | null;
  setup?: Setup | null;
}

/** The name under which a version's own world is run in. */
export const OWN_WORLD = "own";

/** A world's title: one text, or one in each language; in Portuguese where its own is missing. */
export function worldTitle({ title }: World, language: Language): string {
  return typeof title === "string" ? title : (title[language] ?? title["pt-BR"]);
}
