import type { BlockArgument } from "../definition";
import { ALL_DEFINITIONS, argumentsOf, type Row } from "../definitions";
import type { Branch, Command, Expression } from "../generator/document";
import type { BlockState, Connection, Ids } from "./state";
import { callParts, defaultOf, valueInput } from "./values";

type Parts = Pick<BlockState, "fields" | "inputs" | "extraState">;

/** The state of a stack of blocks, first block outermost; undefined if there are no commands. */
export function stackOf(commands: readonly Command[], ids: Ids): { block: BlockState } | undefined {
  let below: { block: BlockState } | undefined;
  for (const block of commands.map((command) => commandBlock(command, ids)).reverse()) {
    below = { block: below ? { ...block, next: below } : block };
  }
  return below;
}

/** The comment that a pupil wrote on a block, in Blockly's format. */
export function commentIcon(comment: unknown): Pick<BlockState, "icons"> {
  if (typeof comment !== "string" || comment === "") return {};
  return { icons: { comment: { text: comment, pinned: false, height: 100, width: 220 } } };
}

function commandBlock(command: Command, ids: Ids): BlockState {
  const head = { ...ids.claim(command.block), ...commentIcon(command.comment) };
  const special = SPECIAL[command.action];
  if (special) return { ...head, ...special(command, ids) };
  const row = rowFor(command);
  return { type: row.type, ...head, ...partsOf(row, command, ids) };
}

const SPECIAL: Readonly<Record<string, (command: Command, ids: Ids) => Parts & { type: string }>> =
  {
    turn: (command) => ({ type: "turn", ...signedAngle(command.angle as Expression) }),
    arc: (command) => {
      const parts = signedAngle(command.angle as Expression);
      const radius = valueInput(command.radius as Expression, { number: 1 });
      return { type: "arc", ...parts, inputs: { ...parts.inputs, RADIUS: radius } };
    },
    conditional_execution: (command, ids) => ({ type: "if", ...conditional(command, ids) }),
    call: (command) => ({
      type: "call",
      ...callParts(
        String(command.function),
        command.arguments as Record<string, Expression> | undefined,
      ),
    }),
  };

/** The row whose inputs and fields fit the parameters best; some actions have several blocks. */
function rowFor(command: Command): Row {
  let best: { row: Row; fit: number } | null = null;
  for (const row of ALL_DEFINITIONS) {
    const { makes } = row;
    if (!makes || !("action" in makes) || makes.action !== command.action) continue;
    const fixed = Object.entries(makes.fixed ?? {});
    if (fixed.some(([key, value]) => command[key] !== value)) continue;
    if (argumentsOf(row).some((argument) => isComputedChoice(argument, command))) continue;
    const keys = argumentsOf(row).flatMap(({ key }) => (key === undefined ? [] : [key]));
    const given = keys.filter((key) => command[key] !== undefined).length;
    const fit = 2 * given - (keys.length - given);
    if (!best || fit > best.fit) best = { row, fit };
  }
  if (!best) throw new Error(`there is no block for ${command.action}`);
  return best.row;
}

/** Whether the value is computed although the block offers fixed choices only. */
function isComputedChoice({ type, key = "" }: BlockArgument, command: Command): boolean {
  return type === "field_dropdown" && typeof command[key] === "object";
}

function partsOf(row: Row, command: Command, ids: Ids): Parts {
  const fields: Record<string, unknown> = {};
  const inputs: Record<string, Connection> = {};
  for (const argument of argumentsOf(row) as readonly BlockArgument[]) {
    const { name, key, type, shadow } = argument;
    if (!name || key === undefined) continue;
    const value = command[key];
    if (type === "input_statement") Object.assign(inputs, inside(name, value as Command[], ids));
    else if (type === "input_value") {
      const given = value ?? defaultOf(shadow);
      if (given !== undefined) inputs[name] = valueInput(given as Expression, shadow);
    } else fields[name] = fieldValue(value, key);
  }
  return { fields, inputs };
}

function fieldValue(value: unknown, key: string): unknown {
  if (key === "avoid") return value === true ? "TRUE" : "FALSE";
  return value ?? "";
}

function inside(name: string, commands: readonly Command[], ids: Ids): Record<string, Connection> {
  const stack = stackOf(commands, ids);
  return stack ? { [name]: stack } : {};
}

/**
 * Splits an angle into direction and amount. A negative number and `0 - x` are turns to the right.
 */
function signedAngle(angle: Expression): Parts {
  const subtracted = negatedPart(angle);
  const right = typeof angle === "number" ? angle < 0 : subtracted !== null;
  const amount = typeof angle === "number" ? Math.abs(angle) : (subtracted ?? angle);
  return {
    fields: { DIRECTION: right ? "RIGHT" : "LEFT" },
    inputs: { ANGLE: valueInput(amount, { number: 90 }) },
  };
}

function negatedPart(angle: Expression): Expression | null {
  if (typeof angle !== "object" || !("op" in angle) || angle.op !== "-") return null;
  const [zero, part] = angle.args;
  return zero === 0 && part !== undefined && typeof part !== "number" ? part : null;
}

function conditional(command: Command, ids: Ids): Parts {
  const first = { condition: command.condition, commands: command.commands } as Branch;
  const others = (command.elif ?? []) as Branch[];
  const last = (command.else ?? []) as Command[];
  const inputs = Object.assign(
    {},
    ...[first, ...others].map((branch, index) => branchInputs(branch, index || "", ids)),
    inside("ELSE", last, ids),
  );
  const extraState = {
    ...(others.length > 0 && { elif: others.length }),
    ...(last.length > 0 && { else: true }),
  };
  return { inputs, ...(Object.keys(extraState).length > 0 && { extraState }) };
}

function branchInputs(
  { condition, commands }: Branch,
  suffix: number | "",
  ids: Ids,
): Record<string, Connection> {
  const inputs = inside(`THEN${suffix}`, commands, ids);
  if (condition === undefined) return inputs;
  return {
    [`CONDITION${suffix}`]: valueInput(condition),
    ...inputs,
  };
}
