import type * as Blockly from "blockly/core";
import type { ValueBlockType } from "../blocks/definitions";
import type { Expression } from "./document";

/** One generator per block that gives a value. A block without one does not compile. */
export const VALUES: Readonly<Record<ValueBlockType, (block: Blockly.Block) => Expression>> = {
  gesture_result: () => ({ gesture: "result" }),
  text_letter: (block) => String(block.getFieldValue("TEXT")),
  compare: (block) => operation(block, block.getFieldValue("OPERATOR"), "A", "B"),
  logic_operation: (block) => operation(block, block.getFieldValue("OPERATOR"), "A", "B"),
  not: (block) => operation(block, "not", "A"),
};

/** The value in a hole, or null when it is empty. */
export function generateInput(block: Blockly.Block, input: string): Expression | null {
  const value = block.getInputTargetBlock(input);
  if (!value || value.isInsertionMarker()) return null;
  return VALUES[value.type as ValueBlockType](value);
}

/** Holes left empty shorten `args`; the reader then faults the command that asks. */
function operation(block: Blockly.Block, op: string, ...inputs: string[]): Expression {
  const args = inputs
    .map((input) => generateInput(block, input))
    .filter((argument) => argument !== null);
  return { op, args };
}
