import type { Level } from "../blocks/definition";
import type { OfferedActions } from "../blocks/toolbox/toolbox";
import type { Language } from "../i18n";
import type { EvaluateExpression } from "./decorations/value_bubble";
import type { ThemeName } from "./themes";

/** Settings and callbacks of an editor. */
export interface EditorOptions {
  container: HTMLElement;
  language: Language;
  theme: ThemeName;
  /** URL of Blockly's images and cursors, with a slash at the end. */
  mediaPath: string;
  /** Level of the toolbox: 1 first steps, 2 explorer, 3 everything (the default). */
  level?: Level;
  /** The actions that an activity offers; null, the default, for all blocks of the level. */
  offered?: OfferedActions;
  programName?: () => string;
  /**
   * Receives the ids of all breakpoint blocks when they change. Without it the editor has no
   * breakpoints.
   */
  onBreakpoints?(ids: readonly string[]): void;
  /** Evaluates an expression. Without it the editor shows no values. */
  evaluate?: EvaluateExpression;
  /** Called on undo if the undo stack of this session is empty. */
  onNothingToUndo?(): void;
  onChange(content: { workspace: object; document: object | null }): void;
}
