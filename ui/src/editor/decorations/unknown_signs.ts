import type * as Blockly from "blockly/core";
import { isKnownSign, knownSigns } from "../../blocks/known_signs";
import { blockText } from "../../blocks/texts";
import { commandOf, comparedWith } from "./compared";

/**
 * Unknown signs by command. They are no faults, because a person can answer a capture with them.
 */
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

/** Lines of the warning about a command's unknown signs. */
export function unknownSignTexts(names: ReadonlySet<string>): string[] {
  const remedy = blockText(knownSigns()?.hasClass ? "SIGN_TO_TEACH" : "SIGN_BY_HAND");
  return [...[...names].map((name) => blockText("SIGN_UNKNOWN", name)), remedy];
}

/** The sign on a block, if the block is compared with a gesture or sets one; else null. */
function signOn(block: Blockly.Block): string | null {
  const isSign = block.type === "text_letter";
  if (!isSign && block.type !== "text") return null;
  const around = block.getParent();
  const isCompared =
    around?.type === "compare" && (isSign || comparedWith(block)?.type === "gesture_result");
  if (!isCompared && around?.type !== "set_gesture_result") return null;
  return String(block.getFieldValue("TEXT"));
}
