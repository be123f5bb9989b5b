import type * as Blockly from "blockly/core";
import type { Shadow } from "../definition";
import type { TextKey } from "../texts";
import { blockText } from "../texts";

/** The shadow block of an empty input, in Blockly's format. */
export function shadowState(shadow: Shadow): Blockly.serialization.blocks.State {
  if ("number" in shadow) return { type: "number", fields: { NUM: shadow.number } };
  if ("letter" in shadow) return { type: "text_letter", fields: { TEXT: shadow.letter } };
  return { type: "text", fields: { TEXT: blockText(shadow.textKey as TextKey) } };
}
