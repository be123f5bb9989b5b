import type { Category as CommandCategory } from "./categories";
import type { BlockDefinition } from "./definition";
import type { Category } from "./hues";
import { flow } from "./table/flow";
import { functions } from "./table/functions";
import { gestures } from "./table/gestures";
import { lists } from "./table/lists";
import { logic } from "./table/logic";
import { maths } from "./table/maths";
import { motion } from "./table/motion";
import { sensing } from "./table/sensing";
import { show } from "./table/show";
import { start } from "./table/start";
import { text } from "./table/text";
import { variables } from "./table/variables";

/**
 * The block table: all blocks by category, in the order of the toolbox. A new block needs a row in
 * the file of its category, and texts in `i18n/LANG/blocks.ts`. A command whose parameters all have
 * keys needs no more; any other block needs a generator and a loader. The compiler and the tests
 * beside this file report a missing part.
 */
export const DEFINITIONS = {
  start,
  motion,
  sensing,
  flow,
  logic,
  gestures,
  show,
  variables,
  maths,
  text,
  lists,
  functions,
} as const satisfies Record<Category, readonly BlockDefinition[]>;

type Definition = (typeof DEFINITIONS)[Category][number];

export type BlockType = Definition["type"];
export type ValueBlockType = Extract<Definition, { output: unknown }>["type"];
export type StatementBlockType = Extract<Definition, { previousStatement: null }>["type"];

export const CATEGORIES = Object.keys(DEFINITIONS) as Category[];

/** A row of the table; its type is one of the known block types. */
export type Row = BlockDefinition & { readonly type: BlockType };

export const ALL_DEFINITIONS: readonly Row[] = CATEGORIES.flatMap(
  (category): readonly Row[] => DEFINITIONS[category],
);

const BY_TYPE = new Map<string, Row>(ALL_DEFINITIONS.map((row) => [row.type, row]));

/** The row of a type of block. */
export function definitionOf(type: string): Row {
  const row = BY_TYPE.get(type);
  if (!row) throw new Error(`there is no block ${type}`);
  return row;
}

/** Inputs and fields of a block that hold parameters, including its second line. */
export function argumentsOf(row: BlockDefinition) {
  return [...row.args0, ...(row.args1 ?? [])];
}

const BY_SENSOR = new Map<string, Row>(
  ALL_DEFINITIONS.flatMap((row) => {
    const sensors: readonly string[] = row.makes && "sensor" in row.makes ? row.makes.sensor : [];
    return sensors.map((sensor) => [sensor, row] as const);
  }),
);

/** The row of the block that reads a sensor. */
export function sensorRow(sensor: string): Row {
  const row = BY_SENSOR.get(sensor);
  if (!row) throw new Error(`there is no sensor ${sensor}`);
  return row;
}

const CATEGORY_OF_ACTION = new Map(
  ALL_DEFINITIONS.flatMap(({ makes, style }) =>
    makes && "action" in makes ? [[makes.action, style as CommandCategory] as const] : [],
  ),
);

/** The category of an action of the program document. */
export function categoryOf(action: string): CommandCategory {
  return CATEGORY_OF_ACTION.get(action) ?? "flow";
}
