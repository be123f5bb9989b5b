import type * as Blockly from "blockly/core";

/** Distance from the workspace's corner to the start block, in pixels. */
const MARGIN = 32;

/** Shows the program at full size, with its start block in the upper left corner. */
export function showFromTheStart(workspace: Blockly.WorkspaceSvg): void {
  workspace.setScale(1);
  scrollToStart(workspace);
}

/** Scrolls until the start block is in the upper left corner. */
export function scrollToStart(workspace: Blockly.WorkspaceSvg): void {
  const [start] = workspace.getBlocksByType("program_start") as Blockly.BlockSvg[];
  const { x, y } = start?.getRelativeToSurfaceXY() ?? { x: 0, y: 0 };
  const { scale } = workspace;
  workspace.scroll(MARGIN - x * scale, MARGIN - y * scale);
}
