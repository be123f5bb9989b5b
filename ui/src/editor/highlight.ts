import type * as Blockly from "blockly/core";
import { setRing } from "./renderer";

/** Lights the block that is running and keeps it in view. */
export class Highlight {
  blockId: string | null = null;

  constructor(private readonly workspace: Blockly.WorkspaceSvg) {}

  show(blockId: string | null): void {
    if (blockId === this.blockId) return;
    this.ring(false);
    this.blockId = blockId;
    this.ring(true);
    this.bringIntoView();
  }

  private ring(shown: boolean): void {
    const block = this.block();
    if (block) setRing(block, "running", shown);
  }

  private bringIntoView(): void {
    const block = this.block();
    if (!block || this.workspace.isDragging()) return;
    this.workspace.scrollBoundsIntoView(block.getBoundingRectangleWithoutChildren(), 24);
  }

  private block(): Blockly.BlockSvg | null {
    return this.blockId === null ? null : this.workspace.getBlockById(this.blockId);
  }
}
