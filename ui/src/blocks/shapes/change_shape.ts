import * as Blockly from "blockly/core";
import { inOneStep } from "../fields/name_field";

/** Changes the shape of a block as one step that the user can undo. */
export function changeShape(block: Blockly.Block, change: () => void): void {
  if (block.isInFlyout) return;
  inOneStep(() => {
    const before = shapeOf(block);
    change();
    const after = shapeOf(block);
    if (before === after) return;
    const type = Blockly.Events.get(
      Blockly.Events.BLOCK_CHANGE,
    ) as typeof Blockly.Events.BlockChange;
    Blockly.Events.fire(new type(block, "mutation", null, before, after));
  });
}

function shapeOf(block: Blockly.Block): string {
  const state: unknown = block.saveExtraState?.();
  return state ? JSON.stringify(state) : "";
}
