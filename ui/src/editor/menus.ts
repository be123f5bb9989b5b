import * as Blockly from "blockly/core";
import { definitionOf } from "../blocks/definitions";

/** Of Blockly's menu entries, those that mean nothing here. */
const IDLE_ENTRIES = ["blockInline", "blockHelp", "commentCreate"];

let adapted = false;

/** Makes Blockly's menus say what is so of our blocks. The menus are one for the page: once is enough. */
export function adaptMenus(): void {
  if (adapted) return;
  adapted = true;
  const { registry } = Blockly.ContextMenuRegistry;
  for (const entry of IDLE_ENTRIES) if (registry.getItem(entry)) registry.unregister(entry);
  adapt("blockDelete", (item) => {
    item.displayText = ({ block }) => deletionWords(block);
  });
  adapt("blockComment", (entry) => {
    const allowed = entry.preconditionFn;
    entry.preconditionFn = (scope, event) =>
      canHoldComment(scope.block) ? allowed(scope, event) : "hidden";
    const addOrRemove = entry.callback;
    entry.callback = (scope, ...rest) => {
      addOrRemove(scope, ...rest);
      openComment(scope.block);
    };
  });
}

type Scope = Blockly.ContextMenuRegistry.Scope;

/** An entry that acts, as all of ours do; separators have neither of these. */
interface Entry {
  displayText: (scope: Scope) => string;
  preconditionFn: (scope: Scope, event: Event) => string;
  callback: (scope: Scope, ...rest: unknown[]) => void;
}

function adapt(id: string, change: (entry: Entry) => void): void {
  const item = Blockly.ContextMenuRegistry.registry.getItem(id);
  if (item) change(item as unknown as Entry);
}

/** Blockly counts what stands in the holes of a block as blocks; a pupil does not. */
function deletionWords(block?: Blockly.BlockSvg): string {
  const after = new Set(block?.getNextBlock()?.getDescendants(false));
  const count = (block?.getDescendants(false) ?? []).filter(
    (one) => !one.isShadow() && !after.has(one),
  ).length;
  if (count <= 1) return Blockly.Msg.DELETE_BLOCK ?? "";
  return (Blockly.Msg.DELETE_X_BLOCKS ?? "").replace("%1", String(count));
}

/** A comment that was just added is there to be written, so the hand need not look for its icon first. */
function openComment(block?: Blockly.BlockSvg): void {
  const icon = block?.getIcon(Blockly.icons.IconType.COMMENT);
  if (!icon) return;
  void icon.setBubbleVisible(true).then(() => {
    const bubble = icon.getBubble();
    if (bubble) Blockly.getFocusManager().focusNode(bubble);
    bubble?.performAction?.();
  });
}

/** What is written on a block goes with its command into the document; values have no place there. */
function canHoldComment(block?: Blockly.BlockSvg): boolean {
  const makes = block ? definitionOf(block.type).makes : null;
  return makes !== null && ("action" in makes || "function" in makes);
}
