import * as Blockly from "blockly/core";
import { registerBlocks } from "../../blocks";
import { shownWorkspace } from "../../blocks/loader";
import type { Language } from "../../i18n";
import { onStage } from "../block_drawings";
import { applyLanguage } from "../locale";
import { registerRenderer } from "../renderer";
import { dimLooseBlocks, ensureStartBlock } from "../start_block";
import { patchAriaUpdates, withoutEvents } from "../without_events";
import { BlockPaints } from "./canvas_paints";

type Ctx = CanvasRenderingContext2D;

/** A block with everything inside it, without the blocks below it; sizes are in pixels at scale 1. */
export interface DrawnBlock {
  readonly width: number;
  /** Distance to the next block of the stack. */
  readonly height: number;
  /** Paints the block with its corner at the canvas's origin; marks the running block, which may be inside it. */
  paint(ctx: Ctx, running: string | null): void;
  /** Whether a block of this id is it, or is inside it. */
  has(id: string): boolean;
}

/** Blocks from top to bottom. */
export type DrawnStack = readonly DrawnBlock[];

/** Width of the mark around the running block, and of its dark edge. */
const MARK = 5;
const EDGE = 8;
const MARK_COLOUR = "#ffc400";
const EDGE_COLOUR = "#211f1b";

/**
 * The stacks of a stored workspace, for drawing on a canvas in the light theme. Throws if the
 * workspace has blocks that this version does not know.
 */
export async function drawProgram(saved: object, language: Language): Promise<DrawnStack[]> {
  applyLanguage(language);
  registerBlocks();
  registerRenderer();
  patchAriaUpdates();
  const parts: BlockPaints[] = [];
  const stacks = onStage("light", (workspace) => {
    withoutEvents(() => {
      Blockly.serialization.workspaces.load(shownWorkspace(saved), workspace);
      ensureStartBlock(workspace);
      dimLooseBlocks(workspace);
      for (const block of workspace.getAllBlocks(false)) hideButtons(block);
    });
    Blockly.renderManagement.triggerQueuedRenders(workspace);
    return workspace.getTopBlocks(true).map((top) => drawStack(top, parts));
  });
  await Promise.all(parts.map((one) => one.ready()));
  return stacks;
}

/** Hides plus and minus buttons, which do nothing on a picture. */
function hideButtons(block: Blockly.BlockSvg): void {
  for (const field of block.getFields()) {
    if (field instanceof Blockly.FieldImage && field.isClickable()) field.setVisible(false);
  }
}

function drawStack(top: Blockly.BlockSvg, parts: BlockPaints[]): DrawnStack {
  const blocks: DrawnBlock[] = [];
  for (let block: Blockly.BlockSvg | null = top; block; block = block.getNextBlock()) {
    const drawing = new BlockPaints(block.getSvgRoot(), block.getNextBlock()?.getSvgRoot() ?? null);
    parts.push(drawing);
    blocks.push({
      ...sizeOf(block),
      paint: (ctx, running) => paint(ctx, drawing, running),
      has: (id) => drawing.outlines.has(id),
    });
  }
  return blocks;
}

function sizeOf(block: Blockly.BlockSvg): { width: number; height: number } {
  const { x, y } = block.getRelativeToSurfaceXY();
  const next = block.getNextBlock();
  const boxes = inside(block).map((one) => one.getBoundingRectangleWithoutChildren());
  const bottom = next?.getRelativeToSurfaceXY().y ?? Math.max(...boxes.map((box) => box.bottom));
  return { width: Math.max(...boxes.map((box) => box.right)) - x, height: bottom - y };
}

/** The block and all blocks inside it. */
function inside(block: Blockly.BlockSvg): Blockly.BlockSvg[] {
  const next = block.getNextBlock();
  const children = block.getChildren(false).filter((child) => child !== next);
  return [block, ...children.flatMap((child) => child.getDescendants(false))];
}

function paint(ctx: Ctx, { paints, outlines }: BlockPaints, running: string | null): void {
  for (const one of paints) one(ctx);
  const outline = running === null ? undefined : outlines.get(running);
  if (!outline) return;
  ctx.lineJoin = "round";
  for (const [colour, width] of [
    [EDGE_COLOUR, EDGE],
    [MARK_COLOUR, MARK],
  ] as const) {
    ctx.strokeStyle = colour;
    ctx.lineWidth = width;
    ctx.stroke(outline);
  }
}
