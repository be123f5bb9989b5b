import * as Blockly from "blockly/core";

const START = "program_start";
const LOOSE = "pinel_loose";

/** Every program has its start block, whatever was loaded. */
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

/** Blocks that a stack may begin with and be part of the program. */
const ROOTS = [START, "function_def"];

/** Only what hangs below the start block, or defines a function, runs; the rest stays and is drawn dimmed. */
export function markLooseBlocks(workspace: Blockly.WorkspaceSvg): void {
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
