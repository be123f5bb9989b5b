import type * as Blockly from "blockly/core";
import type { ValueBlockType } from "../blocks/definitions";
import { callOf } from "../blocks/shapes/call";
import { valuesOf } from "../blocks/shapes/list_data";
import { itemInput } from "../blocks/shapes/variadic";
import type { Expression, Literal } from "./document";

/** One generator per block that gives a value. A block without one does not compile. */
export const VALUES: Readonly<Record<ValueBlockType, (block: Blockly.Block) => Expression>> = {
  number: (block) => Number(block.getFieldValue("NUM")),
  text: text("TEXT"),
  text_letter: text("TEXT"),
  colour: text("COLOUR"),
  boolean: (block) => block.getFieldValue("BOOL") === "TRUE",
  list_of: (block) => items(block) as Literal[],
  list_data: valuesOf,
  variable: (block) => ({ var: String(block.getFieldValue("NAME")) }),
  gesture_result: () => ({ gesture: "result" }),

  compare: chosen("A", "B"),
  logic_operation: (block) => ({ op: operator(block), args: items(block) }),
  not: operation("not", "A"),
  arithmetic: chosen("A", "B"),
  remainder: operation("%", "A", "B"),
  math_function: chosen("A"),
  min_max: (block) => ({ op: operator(block), args: items(block) }),
  random_int: operation("random_int", "A", "B"),
  join: (block) => ({ op: "join", args: items(block) }),
  item: operation("item", "LIST", "INDEX"),
  length: operation("length", "A"),

  distance_sensor: (block) => ({
    sensor: "distance",
    direction: String(block.getFieldValue("DIRECTION")),
  }),
  sonar: (block) => ({ sensor: "sonar", ...parameter(block, "index", "INDEX") }),
  lidar: (block) => ({ sensor: "lidar", ...parameter(block, "angle", "ANGLE") }),
  position: (block) => ({ sensor: String(block.getFieldValue("AXIS")) }),
  heading: () => ({ sensor: "heading" }),
  bumper: () => ({ sensor: "bumper" }),
  time: () => ({ sensor: "time" }),
  floor: () => ({ sensor: "floor" }),
  cell: () => ({ sensor: "cell" }),
  call_value: (block) => ({ call: callOf(block).name, arguments: generateCallArguments(block) }),
};

/** The value in a hole, or null when it is empty. */
export function generateInput(block: Blockly.Block, input: string): Expression | null {
  const value = block.getInputTargetBlock(input);
  if (!value || value.isInsertionMarker()) return null;
  return VALUES[value.type as ValueBlockType](value);
}

/** The values of a call by the names of their parameters. */
export function generateCallArguments(block: Blockly.Block): Record<string, Expression> {
  const found: Record<string, Expression> = {};
  callOf(block).parameters.forEach((name, index) => {
    const value = generateInput(block, `ARG${index}`);
    if (value !== null) found[name] = value;
  });
  return found;
}

function text(field: string) {
  return (block: Blockly.Block) => String(block.getFieldValue(field));
}

function operator(block: Blockly.Block): string {
  return String(block.getFieldValue("OPERATOR"));
}

function operation(op: string, ...inputs: string[]) {
  return (block: Blockly.Block) => ({ op, args: args(block, inputs) });
}

/** An operation with its operator in a dropdown. */
function chosen(...inputs: string[]) {
  return (block: Blockly.Block) => ({ op: operator(block), args: args(block, inputs) });
}

/** Holes left empty shorten `args`; the reader then faults the command that asks. */
function args(block: Blockly.Block, inputs: readonly string[]): Expression[] {
  return inputs.map((input) => generateInput(block, input)).filter((argument) => argument !== null);
}

/** The values of a block that can have more of them. */
function items(block: Blockly.Block): Expression[] {
  const inputs: string[] = [];
  for (let index = 0; block.getInput(itemInput(index)); index++) inputs.push(itemInput(index));
  return args(block, inputs);
}

function parameter(block: Blockly.Block, key: "index" | "angle", input: string) {
  const value = generateInput(block, input);
  return value === null ? {} : { [key]: value };
}
