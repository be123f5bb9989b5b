import type * as Blockly from "blockly/core";

/** Distance from the workspace's corner to the start block, and of the widest block from the right edge, in pixels. */
const MARGIN = 32;
const MARGIN_RIGHT = 8;

/** A view narrower than this shows the program smaller, where its numbers would be cut, but still legible. */
const NARROW_PX = 400;
const MIN_SCALE = 0.7;
/** Width of the invitation below a start block without a program, in workspace units. */
const INVITATION = 264;

/** Shows the program at full size, or as wide as a narrow view, with its start block in the upper left corner. */
export function showFromTheStart(workspace: Blockly.WorkspaceSvg): void {
  workspace.setScale(scaleFor(workspace));
  scrollToStart(workspace);
}

function scaleFor(workspace: Blockly.WorkspaceSvg): number {
  const { width } = workspace.getMetricsManager().getViewMetrics();
  if (width >= NARROW_PX) return 1;
  const { left, right } = workspace.getBlocksBoundingBox();
  const fitting = (width - MARGIN - MARGIN_RIGHT) / Math.max(INVITATION, right - left);
  return Math.min(1, Math.max(MIN_SCALE, fitting));
}

/** Scrolls until the start block is in the upper left corner. */
export function scrollToStart(workspace: Blockly.WorkspaceSvg): void {
  const [start] = workspace.getBlocksByType("program_start") as Blockly.BlockSvg[];
  const { x, y } = start?.getRelativeToSurfaceXY() ?? { x: 0, y: 0 };
  const { scale } = workspace;
  workspace.scroll(MARGIN - x * scale, MARGIN - y * scale);
}
