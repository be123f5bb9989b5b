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

/** Scrolls until the block is in view, unless the user is dragging. */
export function bringIntoView(workspace: Blockly.WorkspaceSvg, blockId: string): void {
  const block = workspace.getBlockById(blockId);
  if (!block || workspace.isDragging()) return;
  workspace.scrollBoundsIntoView(block.getBoundingRectangleWithoutChildren(), 24);
}
