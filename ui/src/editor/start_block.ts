import * as Blockly from "blockly/core";

const START = "program_start";
const LOOSE = "pinel_loose";

/** Returns the start block of a program; creates it if it is missing. */
export function ensureStartBlock(workspace: Blockly.WorkspaceSvg): Blockly.BlockSvg {
  const start = (workspace.getBlocksByType(START)[0] as Blockly.BlockSvg) ?? newStart(workspace);
  start.setDeletable(false);
  return start;
}

function newStart(workspace: Blockly.WorkspaceSvg): Blockly.BlockSvg {
  const start = workspace.newBlock(START, "start");
  start.initSvg();
  start.render();
  start.moveBy(32, 32);
  return start;
}

/** Types of blocks that start a stack of the program. */
export const ROOTS = [START, "function_def"];

/** Dims loose blocks. Only blocks below the start block or a function definition run. */
export function dimLooseBlocks(workspace: Blockly.WorkspaceSvg): void {
  Blockly.Events.disable();
  try {
    for (const top of workspace.getTopBlocks(false)) {
      const loose = !ROOTS.includes(top.type);
      for (const block of top.getDescendants(false)) block.setDisabledReason(loose, LOOSE);
    }
  } finally {
    Blockly.Events.enable();
  }
}
