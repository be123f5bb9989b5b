import type { BlockArgument, Shadow } from "../definition";
import { ALL_DEFINITIONS, argumentsOf, type Row, sensorRow } from "../definitions";
import type { Expression, Literal } from "../generator/document";
import { shadowState } from "../shapes/shadows";
import { itemInput } from "../shapes/variadic";
import { COLOURS } from "../table/arguments";
import type { BlockState, Connection } from "./state";

/** Longer lists are shown as one block with their length. */
const MAX_SHOWN = 24;

/** The block that shows an expression. */
export function valueBlock(expression: Expression): BlockState {
  if (Array.isArray(expression)) return listBlock(expression);
  if (typeof expression !== "object") return literalBlock(expression as Literal);
  if ("op" in expression) return operationBlock(expression.op, expression.args);
  if ("var" in expression) return { type: "variable", fields: { NAME: expression.var } };
  if ("gesture" in expression) {
    return { type: expression.gesture === "number" ? "number_shown" : "gesture_result" };
  }
  if ("call" in expression) {
    return { type: "call_value", ...callParts(expression.call, expression.arguments) };
  }
  return sensorBlock(expression as Extract<Expression, { sensor: string }>);
}

/**
 * The content of an input. A literal becomes the input's shadow block if its type fits, anything
 * else a block.
 */
export function valueInput(expression: Expression, shadow?: Shadow): Connection {
  const written = shadow && asShadow(expression, shadow);
  if (written) return { shadow: written };
  const block = valueBlock(expression);
  return shadow ? { shadow: shadowState(shadow), block } : { block };
}

/** Name and values of a call, as extra state and inputs of the call block. */
export function callParts(
  name: string,
  values: Readonly<Record<string, Expression>> = {},
): Pick<BlockState, "extraState" | "inputs"> {
  const parameters = Object.keys(values);
  const inputs: Record<string, Connection> = {};
  parameters.forEach((parameter, index) => {
    inputs[`ARG${index}`] = valueInput(values[parameter] as Expression, { number: 0 });
  });
  return { extraState: { name, ...(parameters.length > 0 && { parameters }) }, inputs };
}

function asShadow(expression: Expression, shadow: Shadow): BlockState | null {
  const { type } = shadowState(shadow);
  const fits = type === "number" ? "number" : "string";
  return typeof expression === fits ? literalBlock(expression as Literal, type) : null;
}

function literalBlock(literal: Literal, textType = "text"): BlockState {
  if (typeof literal === "boolean") {
    return { type: "boolean", fields: { BOOL: literal ? "TRUE" : "FALSE" } };
  }
  // JSON has no -0
  if (typeof literal === "number") return { type: "number", fields: { NUM: literal || 0 } };
  return { type: textType, fields: { TEXT: literal } };
}

function listBlock(values: readonly Literal[]): BlockState {
  if (values.length > MAX_SHOWN) return { type: "list_data", extraState: { values: [...values] } };
  const inputs: Record<string, Connection> = {};
  values.forEach((value, index) => {
    const shadow: Shadow = typeof value === "string" ? { textKey: "WORD" } : { number: 0 };
    inputs[itemInput(index)] = valueInput(value, shadow);
  });
  return { type: "list_of", extraState: { n: values.length }, inputs };
}

const OPERATIONS = new Map<string, Row>(
  ALL_DEFINITIONS.flatMap((row) => {
    const operators = row.makes && "op" in row.makes ? row.makes.op : [];
    return operators.map((op) => [op, row] as const);
  }),
);

/** Input names of the operations that do not use A, B, ..., in the order of their arguments. */
const NAMED_INPUTS: Readonly<Record<string, readonly string[]>> = {
  item: ["LIST", "INDEX"],
  contains: ["LIST", "VALUE"],
  position_of: ["LIST", "VALUE"],
};

function operationBlock(op: string, args: readonly Expression[]): BlockState {
  const row = OPERATIONS.get(op);
  if (!row) throw new Error(`there is no operator ${op}`);
  if (row.type === "compare") return comparison(op, args);
  const names = NAMED_INPUTS[row.type] ?? args.map((_, index) => itemInput(index));
  const inputs: Record<string, Connection> = {};
  args.forEach((argument, index) => {
    const name = names[index] as string;
    inputs[name] = valueInput(argument, shadowOf(row, name));
  });
  const hasChoice = row.args0.some(({ name }) => name === "OPERATOR");
  return {
    type: row.type,
    ...(hasChoice && { fields: { OPERATOR: op } }),
    ...(row.variadic && args.length !== row.variadic.start && { extraState: { n: args.length } }),
    inputs,
  };
}

/**
 * The block of a comparison. A text compared with a gesture is shown as a letter, one compared with
 * the floor sensor as a colour.
 */
function comparison(op: string, [a, b]: readonly Expression[]): BlockState {
  const [left, right] = [a as Expression, b as Expression];
  return {
    type: "compare",
    fields: { OPERATOR: op },
    inputs: { A: comparedWith(left, right), B: comparedWith(right, left) },
  };
}

function comparedWith(side: Expression, other: Expression): Connection {
  if (typeof side === "number") return valueInput(side, { number: 0 });
  if (typeof side !== "string") return valueInput(side);
  if (isSensor(other, "floor") && COLOURS.some((colour) => colour === side)) {
    return { shadow: { type: "colour", fields: { COLOUR: side } } };
  }
  const isGesture = typeof other === "object" && "gesture" in other && other.gesture === "result";
  return { shadow: literalBlock(side, isGesture ? "text_letter" : "text") };
}

function isSensor(expression: Expression, sensor: string): boolean {
  return typeof expression === "object" && "sensor" in expression && expression.sensor === sensor;
}

function sensorBlock(
  expression: { sensor: string } & Partial<Record<string, Expression>>,
): BlockState {
  const row = sensorRow(expression.sensor);
  const fields: Record<string, Expression> = {};
  const inputs: Record<string, Connection> = {};
  for (const { name, key, type, shadow } of row.args0 as readonly BlockArgument[]) {
    const value = expression[key ?? "sensor"];
    if (!name) continue;
    if (type !== "input_value") fields[name] = value as Expression;
    else inputs[name] = valueInput(value ?? defaultOf(shadow) ?? 0, shadow);
  }
  return {
    type: row.type,
    ...(Object.keys(fields).length > 0 && { fields }),
    ...(Object.keys(inputs).length > 0 && { inputs }),
  };
}

/** The number in a block's shadow replaces an optional value that the document omits. */
export function defaultOf(shadow: Shadow | undefined): number | undefined {
  return shadow && "number" in shadow ? shadow.number : undefined;
}

/** The placeholder of an empty input. */
export function shadowOf(row: Row, name: string): Shadow | undefined {
  const argument = (argumentsOf(row) as readonly BlockArgument[]).find((one) => one.name === name);
  return argument?.shadow ?? row.variadic?.shadow ?? undefined;
}
