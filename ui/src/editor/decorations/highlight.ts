import type * as Blockly from "blockly/core";
import { type Ring, setRing } from "../renderer";

/** Highlights one block, such as the running one, with a ring and keeps it in view. */
export class Highlight {
  blockId: string | null = null;

  constructor(
    private readonly workspace: Blockly.WorkspaceSvg,
    private readonly kind: Ring = "running",
  ) {}

  show(blockId: string | null): void {
    if (blockId === this.blockId) return;
    this.ring(false);
    this.blockId = blockId;
    this.ring(true);
    if (blockId) bringIntoView(this.workspace, blockId);
  }

  private ring(shown: boolean): void {
    const block = this.block();
    if (block) setRing(block, this.kind, shown);
  }

  private block(): Blockly.BlockSvg | null {
    return this.blockId === null ? null : this.workspace.getBlockById(this.blockId);
  }
}

/** Height that trash and zoom buttons cover at the bottom of the workspace, in pixels. */
const CONTROLS_PX = 128;

/** Scrolls until the block is in view, unless the user is dragging. */
export function bringIntoView(workspace: Blockly.WorkspaceSvg, blockId: string): void {
  const block = workspace.getBlockById(blockId);
  if (block) bringBoundsIntoView(workspace, block.getBoundingRectangleWithoutChildren());
}

/** Scrolls until the rectangle, in workspace units, is in view and above trash and zoom buttons. */
export function bringBoundsIntoView(
  workspace: Blockly.WorkspaceSvg,
  bounds: Blockly.utils.Rect,
): void {
  if (workspace.isDragging()) return;
  const clear = bounds.clone();
  if (!workspace.isReadOnly()) clear.bottom += CONTROLS_PX / workspace.scale;
  workspace.scrollBoundsIntoView(clear, 24);
}
