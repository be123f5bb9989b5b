import type * as Blockly from "blockly/core";
import type { Shadow } from "../definition";
import type { TextKey } from "../texts";
import { blockText } from "../texts";

/** The block that stands in an input until another is put there. */
export function shadowState(shadow: Shadow): Blockly.serialization.blocks.State {
  if ("number" in shadow) return { type: "number", fields: { NUM: shadow.number } };
  if ("letter" in shadow) return { type: "text_letter", fields: { TEXT: shadow.letter } };
  return { type: "text", fields: { TEXT: blockText(shadow.textKey as TextKey) } };
}
