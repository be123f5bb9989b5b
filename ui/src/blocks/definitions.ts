import type { BlockDefinition } from "./definition";
import { flow } from "./flow";
import { functions } from "./functions";
import { gestures } from "./gestures";
import type { Category } from "./hues";
import { lists } from "./lists";
import { logic } from "./logic";
import { maths } from "./maths";
import { motion } from "./motion";
import { sensing } from "./sensing";
import { show } from "./show";
import { start } from "./start";
import { text } from "./text";
import { variables } from "./variables";

/**
 * The block table: every block there is, by category, in the order of the toolbox. A new one takes a row in the file of
 * its category and words in `texts/`; a command whose parameters have keys needs no more, any other block a generator
 * and a loader. The compiler and the tests beside this file name what is missing.
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

/** A row whose type the compiler knows. */
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

/** Where the parameters of a block stand: its inputs and fields, those of a second line included. */
export function argumentsOf(row: BlockDefinition) {
  return [...row.args0, ...(row.args1 ?? [])];
}
