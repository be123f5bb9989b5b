import type * as Blockly from "blockly/core";

/** The other side of the comparison that contains a value; null without a comparison. */
export function comparedWith(value: Blockly.Block): Blockly.Block | null {
  const around = value.getParent();
  if (around?.type !== "compare") return null;
  return around.getChildren(false).find((block) => block !== value) ?? null;
}

/** The command around a value; null for a loose value. */
export function commandOf(value: Blockly.Block): Blockly.Block | null {
  let block: Blockly.Block | null = value;
  while (block?.outputConnection) block = block.getParent();
  return block;
}
