import type * as Blockly from "blockly/core";
import type { Shadow } from "../definition";
import { commandCount, MOST_SHOWN, workspaceOf } from "../loader";
import { shadowState } from "../shapes/shadows";

interface Saved {
  blocks?: { blocks?: BlockState[] };
  document?: object;
}
type BlockState = Blockly.serialization.blocks.State;
type Inputs = NonNullable<BlockState["inputs"]>;
type ToShadow = (value: unknown) => Shadow;

/**
 * Workspaces saved before version 0.2 kept these values in fields of the block; now they are in inputs of the same name,
 * where any expression fits.
 */
const NOW_INPUTS: Readonly<Record<string, { field: string; shadow: ToShadow }>> = {
  move_forward: { field: "DISTANCE", shadow: number },
  move_backward: { field: "DISTANCE", shadow: number },
  turn: { field: "ANGLE", shadow: number },
  repeat: { field: "TIMES", shadow: number },
  wait: { field: "SECONDS", shadow: number },
  classify_gestures: { field: "TIMEOUT", shadow: number },
  set_gesture_result: { field: "RESULT", shadow: (value) => ({ letter: String(value) }) },
};

function number(value: unknown): Shadow {
  return { number: Number(value) };
}

/** What the block held that was given no value of its own. */
const DEFAULTS: Readonly<Record<string, number | string>> = {
  DISTANCE: 1,
  ANGLE: 90,
  TIMES: 4,
  SECONDS: 1,
  TIMEOUT: 10,
  RESULT: "B",
};

/**
 * A saved workspace as this version writes it. The only place that knows how blocks were saved before.
 *
 * What came as commands over HTTP was saved as `{ document }`: it has its blocks from there, unless they are too many to
 * be shown.
 */
export function upgradeWorkspace(workspace: object): object {
  const { blocks, document, ...rest } = workspace as Saved;
  if (document) return commandCount(document) > MOST_SHOWN ? {} : workspaceOf(document);
  if (!blocks) return workspace;
  return { ...rest, blocks: { ...blocks, blocks: (blocks.blocks ?? []).map(upgradedStack) } };
}

/** A copy of a stack, block after block: the longest are deeper than a recursion may go. */
function upgradedStack(first: BlockState): BlockState {
  const head = upgradedBlock(first);
  for (let block = head; block.next?.block; block = block.next.block as BlockState) {
    block.next = { ...block.next, block: upgradedBlock(block.next.block) };
  }
  return head;
}

function upgradedBlock(saved: BlockState): BlockState {
  const block = { ...saved };
  if (block.type === "if_else") {
    block.type = "if";
    block.extraState = { else: true };
  }
  if (saved.inputs) block.inputs = upgradedInputs(saved.inputs);
  const change = NOW_INPUTS[block.type];
  if (change && !block.inputs?.[change.field]) moveIntoInput(block, change);
  return block;
}

function upgradedInputs(inputs: Inputs): Inputs {
  return Object.fromEntries(
    Object.entries(inputs).map(([name, { block, shadow }]) => [
      name,
      {
        ...(shadow && { shadow: upgradedStack(shadow) }),
        ...(block && { block: upgradedStack(block) }),
      },
    ]),
  );
}

function moveIntoInput(block: BlockState, change: { field: string; shadow: ToShadow }): void {
  const { [change.field]: value, ...fields } = block.fields ?? {};
  block.fields = fields;
  const shadow = shadowState(change.shadow(value ?? DEFAULTS[change.field]));
  // a name of its own, so that the same program opened twice is the same workspace
  if (block.id) shadow.id = `${block.id}/${change.field}`;
  block.inputs = { ...block.inputs, [change.field]: { shadow } };
}
