import * as Blockly from "blockly/core";
import { setRing } from "../renderer";
import { bringBoundsIntoView } from "./highlight";
import { wrapText } from "./wrap_text";

/** A fault of the program, with the block it concerns if there is one. */
export interface Fault {
  block: string | null;
  message: string;
  remedy: string;
  /** Whether its bubble opens only on request, because the screen says the message already. */
  isQuiet?: boolean;
}

const GAP = 12;
/** Width of the widest bubble, in workspace units. */
const ROOM = 300;
/** Offset from the corner of a block to the centre of its icon, where bubbles are anchored. */
const ICON_INSET = 16;
const NOTICE_BUBBLE = "pinelNoticeBubble";

/**
 * Decorates blocks with a ring, and a bubble with the message: red for a fault, amber for advice on
 * a run. Only one bubble is open: that of the first new fault.
 */
export class FaultDecorations {
  /** Faults of the last `show`, without those whose blocks were edited since. */
  shown: readonly Fault[] = [];
  private readonly marked = new Map<string, string>();
  private readonly opening = new Map<Blockly.IIcon, Promise<void>>();

  constructor(
    private readonly workspace: Blockly.WorkspaceSvg,
    private readonly kind: "fault" | "advice" = "fault",
  ) {}

  /**
   * Faults that are shown already stay unchanged; otherwise a closed bubble would reopen at every
   * save.
   */
  show(faults: readonly Fault[]): void {
    const texts = textsByBlock(faults);
    for (const [id, text] of this.marked) if (texts.get(id) !== text) this.clearBlock(id);
    this.shown = faults;
    const added = [...texts].filter(([id, text]) => this.decorate(id, text)).map(([id]) => id);
    const quiet = faults.filter(({ isQuiet }) => isQuiet).map(({ block }) => block);
    const first = added.find((id) => !quiet.includes(id));
    if (first && this.hasRoom()) void this.openAlone(first);
  }

  /** Whether a bubble fits; in a narrower workspace it opens on a press only, the list of faults says the same. */
  private hasRoom(): boolean {
    return this.workspace.getMetricsManager().getViewMetrics(true).width >= ROOM;
  }

  has(id: string): boolean {
    return this.marked.has(id);
  }

  clear(): void {
    for (const id of [...this.marked.keys()]) this.clearBlock(id);
  }

  /** Clears the fault of an edited block; the next check decides whether it is fixed. */
  clearBlock(id: string | null | undefined): void {
    if (!id || !this.marked.delete(id)) return;
    this.shown = this.shown.filter((fault) => fault.block !== id);
    const block = this.workspace.getBlockById(id);
    if (!block) return;
    setRing(block, this.kind, false);
    block.setWarningText(null, `pinel_${this.kind}`);
  }

  /**
   * Opens the bubble of a block and closes all others, including bubbles that are still being
   * drawn.
   */
  private async openAlone(id: string): Promise<void> {
    openedLast.set(this.workspace, id);
    closeBubbles(this.workspace);
    await this.openBubble(id);
    if (openedLast.get(this.workspace) !== id)
      closeBubbles(this.workspace, openedLast.get(this.workspace));
  }

  /**
   * Opens the bubble of a block. On request scrolls both into view, above trash and zoom buttons.
   */
  async openBubble(id: string, isBroughtIntoView = false): Promise<void> {
    const block = this.workspace.getBlockById(id);
    const icon = block?.getIcons().find(hasBubble);
    if (!block || !icon) return;
    // a second request before the first bubble is drawn makes Blockly draw a bubble that never
    // closes
    const opening = this.opening.get(icon) ?? icon.setBubbleVisible(true);
    this.opening.set(icon, opening);
    await opening.finally(() => this.opening.delete(icon));
    const bubble = icon.getBubble();
    // if the fault was cleared meanwhile, its icon is removed but the late bubble is not
    if (!block.getIcons().includes(icon)) return bubble?.dispose();
    this.dress(block, bubble);
    const isBelow = positionBubble(block, bubble) === "below";
    if (bubble && (isBroughtIntoView || isBelow))
      bringBoundsIntoView(this.workspace, around(block, bubble));
  }

  /** Places the open bubbles again, where the workspace has another size. */
  placeBubbles(): void {
    for (const id of this.marked.keys()) {
      const block = this.workspace.getBlockById(id);
      const icon = block?.getIcons().find(hasBubble);
      if (block && icon) positionBubble(block, icon.getBubble());
    }
  }

  private dress(block: Blockly.BlockSvg, bubble: Blockly.IBubble | null): void {
    if (this.kind === "fault" || !(bubble instanceof Blockly.bubbles.TextBubble)) return;
    const isFaulty = block.getSvgRoot().classList.contains("pinelFault");
    bubble.getSvgRoot().classList.toggle(NOTICE_BUBBLE, !isFaulty);
  }

  private decorate(id: string, text: string): boolean {
    const block = this.workspace.getBlockById(id);
    if (!block || this.marked.has(id)) return false;
    this.marked.set(id, text);
    setRing(block, this.kind, true);
    block.setWarningText(text, `pinel_${this.kind}`);
    return true;
  }
}

/** Id of the block whose bubble opened last without a click, by workspace. */
const openedLast = new WeakMap<Blockly.WorkspaceSvg, string>();

function closeBubbles(workspace: Blockly.WorkspaceSvg, but?: string): void {
  const blocks = workspace.getAllBlocks(false).filter((block) => block.id !== but);
  const icons = blocks.flatMap((block) => block.getIcons());
  for (const icon of icons)
    if (hasBubble(icon) && icon.bubbleIsVisible()) void icon.setBubbleVisible(false);
}

/**
 * Places the bubble where it covers no block and needs no tail. If there is space, that is beside
 * the block, else below the stack; the caller then scrolls. If the stack is longer than the view,
 * the bubble does not move.
 */
export function positionBubble(
  block: Blockly.BlockSvg,
  bubble: Blockly.IBubble | null,
): "beside" | "below" | null {
  if (!(bubble instanceof Blockly.bubbles.TextBubble)) return null;
  const view = block.workspace.getMetricsManager().getViewMetrics(true);
  const { left, top } = block.getBoundingRectangleWithoutChildren();
  const stack = block.getRootBlock().getBoundingRectangle();
  const below = stack.bottom + GAP;
  const root = bubble.getSvgRoot() as SVGGraphicsElement;
  const { width, height } = root.getBBox();
  const right = rightBetween(block.getRootBlock(), top, top + height);
  const isBeside = right + GAP + width <= view.left + view.width;
  if (!isBeside && below > Math.min(stack.top, view.top) + view.height) return null;
  const [x, y] = isBeside ? [right + GAP, top] : [left, below];
  bubble.setPositionRelativeToAnchor(x - left - ICON_INSET, y - top - ICON_INSET);
  Blockly.utils.dom.addClass(root, "pinelBesideBubble");
  return isBeside ? "beside" : "below";
}

/** Where the widest block of a stack between two heights ends. */
function rightBetween(stack: Blockly.BlockSvg, from: number, to: number): number {
  const rectangles = stack
    .getDescendants(false)
    .map((block) => block.getBoundingRectangleWithoutChildren())
    .filter(({ top, bottom }) => top < to && bottom > from);
  return Math.max(...rectangles.map(({ right }) => right));
}

/** The rectangle around a block and its bubble, in workspace units. */
function around(block: Blockly.BlockSvg, bubble: Blockly.IBubble): Blockly.utils.Rect {
  const both = block.getBoundingRectangleWithoutChildren().clone();
  const { x, y } = bubble.getRelativeToSurfaceXY();
  const { width, height } = (bubble.getSvgRoot() as SVGGraphicsElement).getBBox();
  both.left = Math.min(both.left, x);
  both.top = Math.min(both.top, y);
  both.right = Math.max(both.right, x + width);
  both.bottom = Math.max(both.bottom, y + height);
  return both;
}

function hasBubble(icon: Blockly.IIcon): icon is Blockly.IIcon & Blockly.IHasBubble {
  return "setBubbleVisible" in icon;
}

function textsByBlock(faults: readonly Fault[]): Map<string, string> {
  const texts = new Map<string, string>();
  for (const { block, message, remedy } of faults) {
    if (block === null) continue;
    const text = [message, remedy]
      .filter(Boolean)
      .map((line) => wrapText(line))
      .join("\n");
    texts.set(block, [texts.get(block), text].filter(Boolean).join("\n"));
  }
  return texts;
}
