import * as Blockly from "blockly/core";

const START = "program_start";
const LOOSE = "pinel_loose";

/** Returns the start block of a program, and creates it where it is missing. */
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

/** Blocks at which a stack of the program may begin. */
export const ROOTS = [START, "function_def"];

/** Only blocks below the start block or in a function definition run. All others are kept and drawn dimmed. */
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
