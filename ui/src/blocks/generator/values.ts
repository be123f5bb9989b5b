import type * as Blockly from "blockly/core";
import type { BlockArgument } from "../definition";
import { definitionOf, type ValueBlockType } from "../definitions";
import { callOf } from "../shapes/call";
import { valuesOf } from "../shapes/list_data";
import { itemInput } from "../shapes/variadic";
import { CHOSEN_SENSOR } from "../table/sensing";
import { SENSOR_ROWS } from "../table/sensor_rows";
import type { Expression, Literal } from "./document";

type SensorBlock = (typeof SENSOR_ROWS)[number]["type"];

const SENSOR_VALUES = Object.fromEntries(SENSOR_ROWS.map(({ type }) => [type, sensor])) as Record<
  SensorBlock,
  typeof sensor
>;

/** One generator per value block. If a value block has no generator, the code does not compile. */
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
  number_shown: () => ({ gesture: "number" }),

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
  contains: operation("contains", "LIST", "VALUE"),
  position_of: operation("position_of", "LIST", "VALUE"),
  length: operation("length", "A"),

  ...SENSOR_VALUES,
  call_value: (block) => ({ call: callOf(block).name, arguments: generateCallArguments(block) }),
};

/** The value in an input, or null if the input is empty. */
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

/** Generates an operation whose operator is chosen in a dropdown. */
function chosen(...inputs: string[]) {
  return (block: Blockly.Block) => ({ op: operator(block), args: args(block, inputs) });
}

/**
 * The values of the inputs. An empty input shortens `args`; the reader then reports the command.
 */
function args(block: Blockly.Block, inputs: readonly string[]): Expression[] {
  return inputs.map((input) => generateInput(block, input)).filter((argument) => argument !== null);
}

/** The values of a block with a variable number of inputs. */
function items(block: Blockly.Block): Expression[] {
  const inputs: string[] = [];
  for (let index = 0; block.getInput(itemInput(index)); index++) inputs.push(itemInput(index));
  return args(block, inputs);
}

/** The reading of a sensor: the block's only sensor or the chosen one, and its argument. */
function sensor(block: Blockly.Block): Expression {
  const row = definitionOf(block.type);
  const [only, ...others] = (row.makes as { sensor: readonly string[] }).sensor;
  const name = others.length > 0 ? String(block.getFieldValue(CHOSEN_SENSOR)) : (only as string);
  const asked: Record<string, Expression> = {};
  for (const argument of row.args0 as readonly BlockArgument[]) {
    if (argument.key === undefined || argument.name === undefined) continue;
    const value =
      argument.type === "input_value"
        ? generateInput(block, argument.name)
        : String(block.getFieldValue(argument.name));
    if (value !== null) asked[argument.key] = value;
  }
  return { sensor: name, ...asked };
}
