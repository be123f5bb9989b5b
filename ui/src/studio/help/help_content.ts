import { createContext } from "preact";
import { useContext } from "preact/hooks";
import type { Example } from "../../api/model";
import type { BlockType } from "../../blocks/definitions";
import type { BlockDrawings } from "../../editor/block_drawings";
import type { OpenProgram } from "../program/open_program";

/** Content of the parts of the help, and their actions in the studio. */
export interface HelpContent {
  readonly drawings: BlockDrawings;
  /** The examples; empty until they are loaded. */
  readonly examples: readonly Example[];
  readonly open: OpenProgram;
  /** Adds a block to the open program. */
  put(type: BlockType): void;
}

export const HelpContext = createContext<HelpContent | null>(null);

export function useHelpContent(): HelpContent {
  const content = useContext(HelpContext);
  if (!content) throw new Error("no help around this part");
  return content;
}
