import * as Blockly from "blockly/core";
import { setRing } from "./renderer";
import { wrapWords } from "./wrap_words";

export interface Fault {
  block: string | null;
  message: string;
  remedy: string;
}

const GAP = 12;
/** From the corner of a block to the middle of its icon, which bubbles hang on. */
const ICON_INSET = 16;
const WARNING = "pinel_fault";

/** Shows each fault where it is: a red ring, and words in a bubble that opens at the first new one. */
export class Faults {
  /** What was asked for last, less what was mended since. */
  shown: readonly Fault[] = [];
  private readonly marked = new Map<string, string>();
  private readonly opening = new Map<Blockly.IIcon, Promise<void>>();

  constructor(private readonly workspace: Blockly.WorkspaceSvg) {}

  /** What is shown already stays as it is, so that a bubble that was closed is not opened with every save. */
  show(faults: readonly Fault[]): void {
    const wanted = wordsByBlock(faults);
    for (const [id, words] of this.marked) if (wanted.get(id) !== words) this.clearBlock(id);
    this.shown = faults;
    const added = [...wanted].filter(([id, words]) => this.mark(id, words));
    if (added[0]) this.openBubble(added[0][0]);
  }

  clear(): void {
    for (const id of [...this.marked.keys()]) this.clearBlock(id);
  }

  /** A pupil who works on a block has understood; the next check will tell whether it is well now. */
  clearBlock(id: string | null | undefined): void {
    if (!id || !this.marked.delete(id)) return;
    this.shown = this.shown.filter((fault) => fault.block !== id);
    const block = this.workspace.getBlockById(id);
    if (!block) return;
    setRing(block, "fault", false);
    block.setWarningText(null, WARNING);
  }

  openBubble(id: string): void {
    const block = this.workspace.getBlockById(id);
    const icon = block?.getIcons().find(hasBubble);
    if (!block || !icon) return;
    // asked again before it has drawn the first, Blockly draws a second one that never goes away
    const opening = this.opening.get(icon) ?? icon.setBubbleVisible(true);
    this.opening.set(icon, opening);
    void opening
      .finally(() => this.opening.delete(icon))
      .then(() => placeBeside(block, icon.getBubble()));
  }

  private mark(id: string, words: string): boolean {
    const block = this.workspace.getBlockById(id);
    if (!block || this.marked.has(id)) return false;
    this.marked.set(id, words);
    setRing(block, "fault", true);
    block.setWarningText(words, WARNING);
    return true;
  }
}

/** Beside its block the bubble hides no other and needs no tail; without room it stays where Blockly put it. */
function placeBeside(block: Blockly.BlockSvg, bubble: Blockly.IBubble | null): void {
  if (!(bubble instanceof Blockly.bubbles.TextBubble)) return;
  const view = block.workspace.getMetricsManager().getViewMetrics(true);
  const { left, right } = block.getBoundingRectangleWithoutChildren();
  const root = bubble.getSvgRoot() as SVGGraphicsElement;
  if (right + GAP + root.getBBox().width > view.left + view.width) return;
  bubble.setPositionRelativeToAnchor(right - left + GAP - ICON_INSET, -ICON_INSET);
  Blockly.utils.dom.addClass(root, "pinelBesideBubble");
}

function hasBubble(icon: Blockly.IIcon): icon is Blockly.IIcon & Blockly.IHasBubble {
  return "setBubbleVisible" in icon;
}

function wordsByBlock(faults: readonly Fault[]): Map<string, string> {
  const words = new Map<string, string>();
  for (const { block, message, remedy } of faults) {
    if (block === null) continue;
    const text = [message, remedy]
      .filter(Boolean)
      .map((line) => wrapWords(line))
      .join("\n");
    words.set(block, [words.get(block), text].filter(Boolean).join("\n"));
  }
  return words;
}
