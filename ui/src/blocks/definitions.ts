import { flow } from "./flow";
import { gestures } from "./gestures";
import type { Category } from "./hues";
import { logic } from "./logic";
import { motion } from "./motion";
import { start } from "./start";

/**
 * Every block there is, by category, in the order of the toolbox. A new one takes a definition in the file of its
 * category, words in `texts/` and a generator in `generator/`; the compiler and `registry.test.ts` name what is missing.
 */
export const DEFINITIONS = { start, motion, flow, logic, gestures } as const satisfies Record<
  Category,
  unknown
>;

type Definition = (typeof DEFINITIONS)[Category][number];

export type BlockType = Definition["type"];
export type ValueBlockType = Extract<Definition, { output: unknown }>["type"];
export type StatementBlockType = Extract<Definition, { previousStatement: null }>["type"];

export const CATEGORIES = Object.keys(DEFINITIONS) as Category[];
export const ALL_DEFINITIONS: readonly Definition[] = CATEGORIES.flatMap(
  (category): readonly Definition[] => DEFINITIONS[category],
);
