import type { Level } from "../blocks/definition";
import type { BlockType } from "../blocks/definitions";
import type { KnownSigns } from "../blocks/known_signs";
import type { OfferedActions } from "../blocks/toolbox/toolbox";
import type { Language } from "../i18n";
import type { EditorElements } from "./elements";
import type { Fault } from "./marks/fault_decorations";
import type { ThemeName } from "./themes";

/** What the page does with an editor; `index.ts` makes one. */
export interface Editor {
  readonly elements: EditorElements;
  /**
   * Replaces the content without firing onChange; null leaves only the start block.
   * Throws, and keeps the current content, when the content holds blocks this version does not know.
   */
  load(workspace: object | null): void;
  content(): { workspace: object; document: object };
  /** The program document that is sent to the robot, without the workspace. */
  document(): object;
  /** Highlights the running block and scrolls it into view; null clears the highlight. */
  highlight(blockId: string | null): void;
  /** Shows faults on their blocks until the block is edited or an empty list is passed. */
  showFaults(faults: Fault[]): void;
  /** Puts a new block into the program, where a click in the palette would put it, as one undo step. */
  append(type: BlockType): void;
  /** Scrolls a block into view and opens its fault bubble, if it has one. */
  reveal(blockId: string): void;
  setLanguage(language: Language): void;
  setTheme(theme: ThemeName): void;
  /**
   * Sets the level of the toolbox, and the actions that an activity offers, null for all. Other blocks that are already
   * in the program stay.
   */
  setLevel(level: Level, offered?: OfferedActions): void;
  /** Sets the signs that blocks offer; a block that names another one is marked. Null while they are not known. */
  setSigns(signs: KnownSigns | null): void;
  /** Sets the names of the world's places; a block that compares with another one is marked. Null while not known. */
  setPlaces(names: readonly string[] | null): void;
  setReadOnly(readOnly: boolean): void;
  /** Shows at a block, in amber, what a run that ended well lacks; null takes it away. */
  showAdvice(advice: Fault | null): void;
  /** While the program runs, what is changed on a block is said to count in the next run. */
  setRunning(running: boolean): void;
  undo(): void;
  redo(): void;
  /**
   * Undoes to a state from before the session; null is the empty program. Returns false and changes nothing when that
   * state equals the current one. Throws as `load` does.
   */
  undoTo(workspace: object | null): boolean;
  /** Lines up loose blocks. */
  tidy(): void;
  zoomToFit(): void;
  /** Call it when the container's size changed in a way that the editor cannot observe. */
  resize(): void;
  dispose(): void;
}
