import type { IconName } from "./icons";

/** From which level on a block stands in the toolbox: first steps, explorer, everything. */
export type Level = 1 | 2 | 3;

/**
 * What a value block gives and what an input accepts. "Literal" marks what is written out on the block itself, which is
 * all that a list may hold; every literal is a number, a text or a truth value as well.
 */
export type ValueType = "Number" | "String" | "Boolean" | "Array" | "Literal";

/** What a block becomes in the document. `fixed` are parameters that no field holds. */
export type Makes =
  | { readonly action: string; readonly fixed?: Readonly<Record<string, unknown>> }
  | { readonly op: readonly string[] }
  | { readonly sensor: readonly string[] }
  | { readonly expression: "literal" | "list" | "variable" | "gesture" | "call" }
  | { readonly function: true }
  | null;

/** Bounds that hands are held to; what a document brings is shown as it is, and faulted by the reader. */
export interface Limits {
  readonly min?: number;
  readonly max?: number;
  readonly precision?: number;
}

/** What stands in an empty input: a number, a text (by the key of its words, or a letter), or a block that shows one. */
export type Shadow =
  | { readonly number: number }
  | { readonly textKey: string }
  | { readonly letter: string };

/** A parameter's place on a block. `key` is its name in the document. */
export type BlockArgument = {
  readonly type: string;
  readonly name?: string;
  readonly key?: string;
  readonly check?: ValueType | readonly ValueType[];
  readonly shadow?: Shadow;
  readonly limits?: Limits;
} & Readonly<Record<string, unknown>>;

/** One more input after another, with plus and minus; the first is A, the second B. */
export interface Variadic {
  readonly check: ValueType | null;
  readonly min: number;
  readonly start: number;
  readonly shadow: Shadow | null;
}

/**
 * A row of the block table: Blockly's JSON of one block, and what it is in the document, in the toolbox and in words.
 * `args0` follows the placeholders of the block's text; `%1` is its icon where it has one. Its words, and its help, are
 * `texts/` LANGUAGE under the type in capitals.
 */
export interface BlockDefinition {
  readonly type: string;
  readonly style: string;
  readonly level: Level;
  readonly makes: Makes;
  readonly icon?: IconName;
  readonly args0: readonly BlockArgument[];
  readonly message1?: string;
  readonly args1?: readonly BlockArgument[];
  readonly output?: ValueType | readonly ValueType[];
  readonly outputShape?: 1 | 2 | 3;
  readonly previousStatement?: null;
  readonly nextStatement?: null;
  readonly hat?: "cap";
  readonly variadic?: Variadic;
  readonly mutator?: string;
  readonly extensions?: readonly string[];
  /** Made from documents, and never offered. */
  readonly hidden?: true;
}
