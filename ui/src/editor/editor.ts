import type { Level } from "../blocks/definition";
import type { BlockType } from "../blocks/definitions";
import type { KnownSigns } from "../blocks/known_signs";
import type { OfferedActions } from "../blocks/toolbox/toolbox";
import type { Language } from "../i18n";
import type { Fault } from "./decorations/fault_decorations";
import type { EditorElements } from "./elements";
import type { ThemeName } from "./themes";

/** The interface of the block editor; `createEditor` in `index.ts` creates one. */
export interface Editor {
  readonly elements: EditorElements;
  /**
   * Replaces the content without firing onChange; null leaves only the start block. If the content
   * has blocks that this version does not know, throws and leaves the editor unchanged.
   */
  load(workspace: object | null): void;
  content(): { workspace: object; document: object };
  /** The program document that is sent to the robot, without the workspace. */
  document(): object;
  /** Highlights the running block and scrolls it into view; null clears the highlight. */
  highlight(blockId: string | null): void;
  /** Shows faults of the program on their blocks, in red, until the block is edited or the list changes. */
  showFaults(faults: Fault[]): void;
  /** Inserts a new block where a click in the flyout would insert it, as one undo step. */
  append(type: BlockType): void;
  /** Scrolls a block into view and opens its fault bubble, if it has one. */
  reveal(blockId: string): void;
  setLanguage(language: Language): void;
  setTheme(theme: ThemeName): void;
  /**
   * Sets the level of the toolbox, and the actions that an activity offers (null for all). Blocks
   * already in the program stay.
   */
  setLevel(level: Level, offered?: OfferedActions): void;
  /**
   * Sets the signs that blocks offer; a block with another sign shows a warning. Null: not loaded
   * yet.
   */
  setSigns(signs: KnownSigns | null): void;
  /**
   * Sets the names of the world's places; a comparison with another name shows a warning. Null: not
   * loaded yet.
   */
  setPlaces(names: readonly string[] | null): void;
  setReadOnly(readOnly: boolean): void;
  /** Shows at blocks why a run failed and advice on it, in amber. */
  showAdvice(advice: readonly Fault[]): void;
  /**
   * While the program runs, a note at each edited field explains that the change applies to the
   * next run.
   */
  setRunning(running: boolean): void;
  undo(): void;
  redo(): void;
  /**
   * Undoes to a state from before the session; null is the empty program. If that state equals the
   * current one, returns false and changes nothing. Throws as `load` does.
   */
  undoTo(workspace: object | null): boolean;
  /** Lines up loose blocks. */
  tidy(): void;
  zoomToFit(): void;
  /** To be called after a change of the container's size that a ResizeObserver does not report. */
  resize(): void;
  dispose(): void;
}
