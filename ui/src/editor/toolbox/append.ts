import * as Blockly from "blockly/core";
import { blockText } from "../../blocks/texts";
import { bringIntoView } from "../decorations/highlight";
import { ROOTS } from "../start_block";

const { ConnectionType } = Blockly;

/**
 * Distance of a new block from the blocks above it, in workspace units. It exceeds the snap radius,
 * within which Blockly pushes blocks apart.
 */
const GAP = 72;

/** Inserts a copy of a block of the flyout into the program. */
export function appendFromFlyout(source: Blockly.BlockSvg): void {
  const workspace = source.workspace.targetWorkspace;
  const state = Blockly.serialization.blocks.save(source, { saveIds: false });
  if (workspace && state) appendBlock(state, workspace);
}

/**
 * Inserts a new block as one undo step, selects it, scrolls it into view and announces it.
 *
 * - A command goes to the end of the program. If a block with a statement input is selected, the
 *   command goes to the end of that input. If a block inside a statement input is selected, the
 *   command goes to the end of the same input.
 * - A value goes into the first free input of the selected block that accepts it.
 * - Any other block lies loose below the program.
 */
export function appendBlock(
  state: Blockly.serialization.blocks.State,
  workspace: Blockly.WorkspaceSvg,
): void {
  const selected = selectedBlock(workspace);
  const group = Blockly.Events.getGroup();
  Blockly.Events.setGroup(true);
  try {
    const below = workspace.getBlocksBoundingBox();
    const { blocks } = Blockly.serialization;
    const placed = { ...state, x: below.left, y: below.bottom + GAP };
    const block = blocks.append(placed, workspace, { recordUndo: true }) as Blockly.BlockSvg;
    const place = connectionFor(block, workspace, selected);
    if (place) connect(place, block);
    finish(block, workspace);
  } finally {
    Blockly.Events.setGroup(group);
  }
}

function finish(block: Blockly.BlockSvg, workspace: Blockly.WorkspaceSvg): void {
  const focus = Blockly.getFocusManager();
  const source = focus.getFocusedNode();
  const isByKeyboard = Blockly.keyboardNavigationController.getIsActive();
  // an undrawn block lies at the origin, and Blockly scrolls to the focused block
  Blockly.renderManagement.triggerQueuedRenders(workspace);
  focus.focusNode(block);
  const staysOpen = workspace.getFlyout()?.autoClose === false;
  if (!staysOpen) workspace.hideChaff();
  // by keyboard the focus returns to the flyout: the next block is often from the same category
  else if (isByKeyboard && source) focus.focusNode(source);
  // scrolls only when the click has ended
  void Blockly.renderManagement
    .finishQueuedRenders()
    .then(() => bringIntoView(workspace, block.id));
  Blockly.utils.aria.announceDynamicAriaState(appendedText(block));
}

/** The block that was selected last; it stays selected while the flyout has the focus. */
function selectedBlock(workspace: Blockly.WorkspaceSvg): Blockly.BlockSvg | null {
  const node = Blockly.FocusableTreeTraverser.findFocusedNode(workspace);
  const block = workspace.getNavigator().getSourceBlockFromNode(node);
  return block?.isShadow() ? block.getParent() : block;
}

function connectionFor(
  block: Blockly.BlockSvg,
  workspace: Blockly.WorkspaceSvg,
  selected: Blockly.BlockSvg | null,
): Blockly.Connection | null {
  if (block.outputConnection) return selected && socketFor(block.outputConnection, selected);
  if (!block.previousConnection) return null;
  const command = selected && commandOf(selected);
  if (command && ROOTS.includes(command.getRootBlock().type)) return insideOf(command);
  const [start] = workspace.getBlocksByType("program_start");
  return start ? endAfter(start) : null;
}

/** The first input of a block that accepts the value and holds no block except a shadow block. */
function socketFor(
  value: Blockly.RenderedConnection,
  block: Blockly.BlockSvg,
): Blockly.Connection | null {
  const free = block.inputList
    .map(({ connection }) => connection)
    .find(
      (one) =>
        one?.type === ConnectionType.INPUT_VALUE &&
        (one.targetBlock()?.isShadow() ?? true) &&
        block.workspace.connectionChecker.canConnect(value, one, false),
    );
  return free ?? null;
}

/** The command around a value, or the command itself. */
function commandOf(block: Blockly.BlockSvg): Blockly.BlockSvg {
  const parent = block.outputConnection?.targetBlock() as Blockly.BlockSvg | undefined;
  return parent ? commandOf(parent) : block;
}

function insideOf(block: Blockly.Block): Blockly.Connection | null {
  const input = statementInputOf(block);
  return input ? endOfStatementInput(input) : endAfter(block);
}

/** The first empty statement input of a block, else its last one. */
function statementInputOf(block: Blockly.Block): Blockly.Connection | null {
  const inputs = block.inputList.flatMap(({ connection }) =>
    connection?.type === ConnectionType.NEXT_STATEMENT ? [connection] : [],
  );
  return inputs.find((input) => !input.targetBlock()) ?? inputs.at(-1) ?? null;
}

function endOfStatementInput(input: Blockly.Connection): Blockly.Connection | null {
  const first = input.targetBlock();
  return first ? endAfter(first) : input;
}

/**
 * The connection after the last block of a stack. If that block is an endless loop, the connection
 * is inside the loop; if it ends a loop or a function, above it.
 */
function endAfter(block: Blockly.Block): Blockly.Connection | null {
  const next = block.getNextBlock();
  if (next) return endAfter(next);
  const input = statementInputOf(block);
  if (block.nextConnection) return block.nextConnection;
  return input ? endOfStatementInput(input) : (block.previousConnection?.targetConnection ?? null);
}

function connect(place: Blockly.Connection, block: Blockly.BlockSvg): void {
  const end = block.outputConnection ?? block.previousConnection;
  if (end) place.connect(end);
}

function appendedText(block: Blockly.BlockSvg): string {
  const text = block.toString();
  const around = block.getSurroundParent();
  if (around) return blockText("APPENDED_INSIDE", text, nameOf(around));
  if (ROOTS.includes(block.getRootBlock().type)) return blockText("APPENDED", text);
  return blockText("APPENDED_LOOSE", text);
}

/** Text of a block, without the blocks in its statement inputs. */
function nameOf(block: Blockly.Block): string {
  return block.inputList
    .filter(({ connection }) => connection?.type !== ConnectionType.NEXT_STATEMENT)
    .flatMap(({ fieldRow, connection }) => [
      ...fieldRow.map((field) => field.getText()),
      connection?.targetBlock()?.toString() ?? "",
    ])
    .filter(Boolean)
    .join(" ");
}

let patched = false;

/**
 * Members of Blockly's private gesture class; Blockly has no public hook for a click on a flyout
 * block.
 */
interface FlyoutClick {
  flyout: Blockly.IFlyout | null;
  targetBlock: Blockly.BlockSvg | null;
  doBlockClick(): void;
}

/**
 * Makes a click anywhere on a flyout block, and Enter, append the block. Blockly itself would drop
 * a copy over other blocks on a click, and start a keyboard move on Enter.
 */
export function patchFlyoutClicks(): void {
  if (patched) return;
  patched = true;
  Blockly.Field.prototype.isClickableInFlyout = () => false;
  const gesture = Blockly.Gesture.prototype as unknown as FlyoutClick;
  const { doBlockClick } = gesture;
  gesture.doBlockClick = function (this: FlyoutClick) {
    if (!this.flyout || !this.targetBlock) doBlockClick.call(this);
    else appendFromFlyout(this.targetBlock);
  };
  const block = Blockly.BlockSvg.prototype;
  const { performAction } = block;
  block.performAction = function (this: Blockly.BlockSvg, event?: KeyboardEvent) {
    if (this.isInFlyout) appendFromFlyout(this);
    else performAction.call(this, event);
  };
}
