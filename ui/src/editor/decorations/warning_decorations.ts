import * as Blockly from "blockly/core";
import { positionBubble } from "./fault_decorations";
import { impossibleIn } from "./impossible";
import { unknownIn, unknownSignTexts } from "./unknown_signs";
import { wrapText } from "./wrap_text";

const WARNING = "pinel_notice";
const CLASS = "pinelNotice";
const BUBBLE = "pinelNoticeBubble";

/**
 * Warnings on commands that can run, but probably not as intended. Their bubbles open on a press
 * only.
 */
export class WarningDecorations {
  private readonly shown = new Map<string, string>();

  constructor(private readonly workspace: Blockly.WorkspaceSvg) {
    workspace.addChangeListener((event) => {
      if (event instanceof Blockly.Events.BubbleOpen && event.isOpen) this.dress(event.blockId);
    });
  }

  /** Updates the warnings; to be called when blocks, known signs or known places have changed. */
  refresh(): void {
    const found = warningsIn(this.workspace);
    for (const id of this.shown.keys()) if (!found.has(id)) this.show(id, null);
    for (const [id, lines] of found) this.show(id, lines.map((line) => wrapText(line)).join("\n"));
  }

  /** Clears the record of shown warnings; to be called when all blocks are recreated. */
  forget(): void {
    this.shown.clear();
  }

  /** Gives the bubble the style of a warning, unless the block also has a fault. */
  private dress(id: string | undefined): void {
    const block = id && this.shown.has(id) ? this.workspace.getBlockById(id) : null;
    const bubble = block?.getIcon(Blockly.icons.IconType.WARNING)?.getBubble();
    if (!(block instanceof Blockly.BlockSvg) || !(bubble instanceof Blockly.bubbles.TextBubble)) {
      return;
    }
    const isFaulty = block.getSvgRoot().classList.contains("pinelFault");
    bubble.getSvgRoot().classList.toggle(BUBBLE, !isFaulty);
    positionBubble(block, bubble);
  }

  private show(id: string, text: string | null): void {
    if ((this.shown.get(id) ?? null) === text) return;
    if (text === null) this.shown.delete(id);
    else this.shown.set(id, text);
    const block = this.workspace.getBlockById(id);
    if (!(block instanceof Blockly.BlockSvg)) return;
    block.setWarningText(text, WARNING);
    block.getSvgRoot().classList.toggle(CLASS, text !== null);
  }
}

/** The lines of each command's warning, by block id. */
function warningsIn(workspace: Blockly.Workspace): Map<string, string[]> {
  const lines = new Map<string, string[]>();
  const add = (id: string, more: string[]) => lines.set(id, [...(lines.get(id) ?? []), ...more]);
  for (const [id, names] of unknownIn(workspace)) add(id, unknownSignTexts(names));
  for (const [id, texts] of impossibleIn(workspace)) add(id, [...texts]);
  return lines;
}
