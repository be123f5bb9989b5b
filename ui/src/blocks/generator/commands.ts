import type * as Blockly from "blockly/core";
import type { BlockArgument } from "../definition";
import { argumentsOf, definitionOf, type StatementBlockType } from "../definitions";
import type { BranchesState } from "../shapes/branches";
import { callOf } from "../shapes/call";
import type { Branch, Command, Expression } from "./document";
import { generateCallArguments, generateInput } from "./values";

type Parameters = Record<string, unknown>;

/** Generators for blocks whose parameters the block table alone cannot describe. */
export const SPECIAL: Readonly<
  Partial<Record<StatementBlockType, (block: Blockly.Block) => Parameters>>
> = {
  turn: signedAngle,
  arc: (block) => ({ ...parameters(block, "radius"), ...signedAngle(block) }),
  if: conditional,
  call: (block) => ({ function: callOf(block).name, arguments: generateCallArguments(block) }),
};

/** The commands of a stack of blocks, from its first block down. */
export function generateStack(first: Blockly.Block | null): Command[] {
  const commands: Command[] = [];
  for (let block = first; block; block = block.getNextBlock()) {
    if (!block.isInsertionMarker()) commands.push(generateCommand(block));
  }
  return commands;
}

/** The comment that a pupil wrote on the block. */
export function commentOf(block: Blockly.Block): { comment?: string } {
  const comment = block.getCommentText();
  return comment ? { comment } : {};
}

function generateCommand(block: Blockly.Block): Command {
  const { makes } = definitionOf(block.type);
  if (!makes || !("action" in makes)) throw new Error(`${block.type} is no command`);
  const special = SPECIAL[block.type as StatementBlockType];
  return {
    action: makes.action,
    ...makes.fixed,
    ...(special ? special(block) : parameters(block)),
    block: block.id,
    ...commentOf(block),
  };
}

/**
 * All parameters of a block, or only one. An empty input is left out; the reader then reports it.
 */
function parameters(block: Blockly.Block, only?: string): Parameters {
  const found: Parameters = {};
  for (const argument of argumentsOf(definitionOf(block.type)) as readonly BlockArgument[]) {
    const { key } = argument;
    if (key === undefined || (only !== undefined && key !== only)) continue;
    const value = parameter(block, argument);
    if (value !== null) found[key] = value;
  }
  return found;
}

function parameter(block: Blockly.Block, { type, name = "", key }: BlockArgument): unknown {
  if (type === "input_value") return generateInput(block, name);
  if (type === "input_statement") return generateStack(block.getInputTargetBlock(name));
  const value = String(block.getFieldValue(name));
  if (key === "avoid") return value === "TRUE";
  return value === "" ? null : value;
}

/** The angle of a turn; a turn to the right is negative. */
function signedAngle(block: Blockly.Block): Parameters {
  const angle = generateInput(block, "ANGLE");
  if (angle === null) return {};
  return { angle: block.getFieldValue("DIRECTION") === "RIGHT" ? negated(angle) : angle };
}

function negated(angle: Expression): Expression {
  if (typeof angle !== "number") return { op: "-", args: [0, angle] };
  // JSON has no -0, so a right turn by 0 would differ from its document after a round trip
  return angle === 0 ? 0 : -angle;
}

function conditional(block: Blockly.Block): Parameters {
  const state = (block.saveExtraState?.() ?? {}) as BranchesState;
  const others = Array.from({ length: state.elif ?? 0 }, (_, index) =>
    branch(block, String(index + 1)),
  );
  return {
    ...branch(block, ""),
    ...(others.length > 0 && { elif: others }),
    ...(state.else && { else: generateStack(block.getInputTargetBlock("ELSE")) }),
  };
}

function branch(block: Blockly.Block, suffix: string): Branch {
  const condition = generateInput(block, `CONDITION${suffix}`);
  return {
    ...(condition !== null && { condition }),
    commands: generateStack(block.getInputTargetBlock(`THEN${suffix}`)),
  };
}
