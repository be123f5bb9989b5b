import * as Blockly from "blockly/core";
import { definitionOf } from "../blocks/definitions";

/** Blockly menu entries that have no use in this application. */
const IDLE_ENTRIES = ["blockInline", "blockHelp", "commentCreate"];

let adapted = false;

/** Adapts Blockly's context menus to our blocks, once per page: the menu registry is global. */
export function adaptMenus(): void {
  if (adapted) return;
  adapted = true;
  const { registry } = Blockly.ContextMenuRegistry;
  for (const entry of IDLE_ENTRIES) if (registry.getItem(entry)) registry.unregister(entry);
  adapt("blockDelete", (item) => {
    item.displayText = ({ block }) => deletionLabel(block);
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

/** A menu entry with an action; separators have none of these members. */
interface MenuEntry {
  displayText: (scope: Scope) => string;
  preconditionFn: (scope: Scope, event: Event) => string;
  callback: (scope: Scope, ...rest: unknown[]) => void;
}

function adapt(id: string, change: (entry: MenuEntry) => void): void {
  const item = Blockly.ContextMenuRegistry.registry.getItem(id);
  if (item) change(item as unknown as MenuEntry);
}

/**
 * Label of the delete entry. It counts blocks without shadow blocks, which Blockly's own label
 * counts.
 */
function deletionLabel(block?: Blockly.BlockSvg): string {
  const after = new Set(block?.getNextBlock()?.getDescendants(false));
  const count = (block?.getDescendants(false) ?? []).filter(
    (one) => !one.isShadow() && !after.has(one),
  ).length;
  if (count <= 1) return Blockly.Msg.DELETE_BLOCK ?? "";
  return (Blockly.Msg.DELETE_X_BLOCKS ?? "").replace("%1", String(count));
}

/** Opens the editor of a comment as soon as the comment is added. */
function openComment(block?: Blockly.BlockSvg): void {
  const icon = block?.getIcon(Blockly.icons.IconType.COMMENT);
  if (!icon) return;
  void icon.setBubbleVisible(true).then(() => {
    const bubble = icon.getBubble();
    if (bubble) Blockly.getFocusManager().focusNode(bubble);
    bubble?.performAction?.();
  });
}

/**
 * Whether a block can hold a comment. The document stores comments with commands and functions, not
 * with values.
 */
function canHoldComment(block?: Blockly.BlockSvg): boolean {
  const makes = block ? definitionOf(block.type).makes : null;
  return makes !== null && ("action" in makes || "function" in makes);
}
