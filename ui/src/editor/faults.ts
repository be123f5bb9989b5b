import * as Blockly from "blockly/core";
import { setRing } from "./renderer";
import { wrapWords } from "./wrap_words";

export interface Fault {
  block: string | null;
  message: string;
  remedy: string;
}

const GAP = 24;
const WARNING = "pinel_fault";

/** Shows each fault where it is: a red ring, and words in a bubble that opens at the first of them. */
export class Faults {
  private readonly marked = new Set<string>();

  constructor(private readonly workspace: Blockly.WorkspaceSvg) {}

  show(faults: readonly Fault[]): void {
    this.clear();
    for (const [id, words] of wordsByBlock(faults)) {
      const block = this.workspace.getBlockById(id);
      if (!block) continue;
      this.marked.add(id);
      setRing(block, "fault", true);
      block.setWarningText(words, WARNING);
    }
    const [first] = this.marked;
    if (first) this.openBubble(first);
  }

  clear(): void {
    for (const id of [...this.marked]) this.clearBlock(id);
  }

  /** A pupil who works on a block has understood; the next check will tell whether it is well now. */
  clearBlock(id: string | null | undefined): void {
    if (!id || !this.marked.delete(id)) return;
    const block = this.workspace.getBlockById(id);
    if (!block) return;
    setRing(block, "fault", false);
    block.setWarningText(null, WARNING);
  }

  private openBubble(id: string): void {
    const block = this.workspace.getBlockById(id);
    const icon = block?.getIcons().find(hasBubble);
    if (!block || !icon) return;
    void icon.setBubbleVisible(true).then(() => placeBeside(block, icon.getBubble()));
  }
}

/** Beside its block the bubble hides no other; where there is no room it stays where Blockly put it. */
function placeBeside(block: Blockly.BlockSvg, bubble: Blockly.IBubble | null): void {
  if (!(bubble instanceof Blockly.bubbles.TextBubble)) return;
  const view = block.workspace.getMetricsManager().getViewMetrics(true);
  const { left, right, top } = block.getBoundingRectangleWithoutChildren();
  const width = (bubble.getSvgRoot() as SVGGraphicsElement).getBBox().width;
  if (right + GAP + width > view.left + view.width) return;
  bubble.setPositionRelativeToAnchor(right - left + GAP, 0);
  if (top < view.top) block.workspace.centerOnBlock(block.id, true);
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
