import * as Blockly from "blockly/core";
import { placeBubble } from "./faults";
import { impossibleIn } from "./impossible";
import { unknownIn, wordsOfSigns } from "./unknown_signs";
import { wrapWords } from "./wrap_words";

const WARNING = "pinel_notice";
const CLASS = "pinelNotice";
const BUBBLE = "pinelNoticeBubble";

/** Notices on commands that can run but hardly do what was meant: no faults. Their bubbles stay closed until pressed. */
export class Notices {
  private readonly shown = new Map<string, string>();

  constructor(private readonly workspace: Blockly.WorkspaceSvg) {
    workspace.addChangeListener((event) => {
      if (event instanceof Blockly.Events.BubbleOpen && event.isOpen) this.dress(event.blockId);
    });
  }

  /** To be called when blocks, known signs or known places have changed. */
  refresh(): void {
    const found = noticesIn(this.workspace);
    for (const id of this.shown.keys()) if (!found.has(id)) this.show(id, null);
    for (const [id, lines] of found) this.show(id, lines.map((line) => wrapWords(line)).join("\n"));
  }

  /** Blocks are about to be made anew: none of them has a notice. */
  forget(): void {
    this.shown.clear();
  }

  /** Its bubble looks like a notice, unless the block has a fault as well. */
  private dress(id: string | undefined): void {
    const block = id && this.shown.has(id) ? this.workspace.getBlockById(id) : null;
    const bubble = block?.getIcon(Blockly.icons.IconType.WARNING)?.getBubble();
    if (!(block instanceof Blockly.BlockSvg) || !(bubble instanceof Blockly.bubbles.TextBubble)) {
      return;
    }
    const isFaulty = block.getSvgRoot().classList.contains("pinelFault");
    bubble.getSvgRoot().classList.toggle(BUBBLE, !isFaulty);
    placeBubble(block, bubble);
  }

  private show(id: string, words: string | null): void {
    if ((this.shown.get(id) ?? null) === words) return;
    if (words === null) this.shown.delete(id);
    else this.shown.set(id, words);
    const block = this.workspace.getBlockById(id);
    if (!(block instanceof Blockly.BlockSvg)) return;
    block.setWarningText(words, WARNING);
    block.getSvgRoot().classList.toggle(CLASS, words !== null);
  }
}

/** The lines of each command's notice, by its id. */
function noticesIn(workspace: Blockly.Workspace): Map<string, string[]> {
  const lines = new Map<string, string[]>();
  const add = (id: string, more: string[]) => lines.set(id, [...(lines.get(id) ?? []), ...more]);
  for (const [id, names] of unknownIn(workspace)) add(id, wordsOfSigns(names));
  for (const [id, words] of impossibleIn(workspace)) add(id, [...words]);
  return lines;
}
