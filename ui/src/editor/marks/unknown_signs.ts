import * as Blockly from "blockly/core";
import { isKnownSign, knownSigns } from "../../blocks/known_signs";
import { word } from "../../blocks/words";
import { placeBeside } from "./faults";
import { wrapWords } from "./wrap_words";

const WARNING = "pinel_sign";
const CLASS = "pinelUnknownSign";
const NOTICE = "pinelNoticeBubble";

/** Warns, on the command that names it, of a sign that the camera does not know: no fault, a person can answer it. */
export class UnknownSigns {
  private readonly warned = new Map<string, string>();

  constructor(private readonly workspace: Blockly.WorkspaceSvg) {
    workspace.addChangeListener((event) => {
      if (event instanceof Blockly.Events.BubbleOpen && event.isOpen) this.dress(event.blockId);
    });
  }

  /** To be called when blocks or known signs have changed. */
  refresh(): void {
    const found = unknownIn(this.workspace);
    for (const id of this.warned.keys()) if (!found.has(id)) this.warn(id, null);
    for (const [id, names] of found) this.warn(id, wordsOf(names));
  }

  /** Blocks are about to be made anew: none of them is warned of. */
  forget(): void {
    this.warned.clear();
  }

  /** Its bubble looks like a notice, unless the block has a fault as well. */
  private dress(id: string | undefined): void {
    const block = id && this.warned.has(id) ? this.workspace.getBlockById(id) : null;
    const bubble = block?.getIcon(Blockly.icons.IconType.WARNING)?.getBubble();
    if (!(block instanceof Blockly.BlockSvg) || !(bubble instanceof Blockly.bubbles.TextBubble)) {
      return;
    }
    const isFaulty = block.getSvgRoot().classList.contains("pinelFault");
    bubble.getSvgRoot().classList.toggle(NOTICE, !isFaulty);
    placeBeside(block, bubble);
  }

  private warn(id: string, words: string | null): void {
    if ((this.warned.get(id) ?? null) === words) return;
    if (words === null) this.warned.delete(id);
    else this.warned.set(id, words);
    const block = this.workspace.getBlockById(id);
    if (!(block instanceof Blockly.BlockSvg)) return;
    block.setWarningText(words, WARNING);
    block.getSvgRoot().classList.toggle(CLASS, words !== null);
  }
}

/** The unknown signs of each command, by its id. */
export function unknownIn(workspace: Blockly.Workspace): Map<string, Set<string>> {
  const found = new Map<string, Set<string>>();
  for (const block of workspace.getAllBlocks(false)) {
    const name = signOn(block);
    const command = name === null || isKnownSign(name) ? null : commandOf(block);
    if (name === null || !command) continue;
    found.set(command.id, (found.get(command.id) ?? new Set()).add(name));
  }
  return found;
}

/** The sign that a block names, where it is compared with a gesture or stands for one. */
function signOn(block: Blockly.Block): string | null {
  const isSign = block.type === "text_letter";
  if (!isSign && block.type !== "text") return null;
  const around = block.getParent();
  const isCompared =
    around?.type === "compare" &&
    (isSign || around.getChildren(false).some(({ type }) => type === "gesture_result"));
  if (!isCompared && around?.type !== "set_gesture_result") return null;
  return String(block.getFieldValue("TEXT"));
}

/** The command around a value; null for one that lies loose. */
function commandOf(value: Blockly.Block): Blockly.Block | null {
  let block: Blockly.Block | null = value;
  while (block?.outputConnection) block = block.getParent();
  return block;
}

function wordsOf(names: ReadonlySet<string>): string {
  const remedy = word(knownSigns()?.hasClass ? "SIGN_TO_TEACH" : "SIGN_BY_HAND");
  const lines = [...[...names].map((name) => word("SIGN_UNKNOWN", name)), remedy];
  return lines.map((line) => wrapWords(line)).join("\n");
}
