import type * as Blockly from "blockly/core";

/** What a value is compared with, in the comparison that holds both; null without one. */
export function comparedWith(value: Blockly.Block): Blockly.Block | null {
  const around = value.getParent();
  if (around?.type !== "compare") return null;
  return around.getChildren(false).find((block) => block !== value) ?? null;
}

/** The command around a value; null for one that lies loose. */
export function commandOf(value: Blockly.Block): Blockly.Block | null {
  let block: Blockly.Block | null = value;
  while (block?.outputConnection) block = block.getParent();
  return block;
}
