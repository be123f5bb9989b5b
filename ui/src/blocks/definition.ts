import type { IconName } from "./icons";

/** The level from which the toolbox offers a block: first steps, explorer, everything. */
export type Level = 1 | 2 | 3;

/**
 * The type of a value block and of an input. "Literal" marks a value that is written on the block
 * itself; a list holds only literals. Every literal also is a number, a text or a truth value.
 */
export type ValueType = "Number" | "String" | "Boolean" | "Array" | "Literal";

/** The part of the document that a block generates. `fixed` are parameters without a field. */
export type Makes =
  | { readonly action: string; readonly fixed?: Readonly<Record<string, unknown>> }
  | { readonly op: readonly string[] }
  | { readonly sensor: readonly string[] }
  | { readonly expression: "literal" | "list" | "variable" | "gesture" | "call" }
  | { readonly function: true }
  | null;

/**
 * Bounds for values that a pupil types. A value from a document is shown unchanged; the server's
 * reader reports its fault.
 */
export interface Limits {
  readonly min?: number;
  readonly max?: number;
  readonly precision?: number;
}

/** The placeholder in an empty input: a number, a text (by the key of its label), or a letter. */
export type Shadow =
  | { readonly number: number }
  | { readonly textKey: string }
  | { readonly letter: string };

/** An input or a field that holds a parameter. `key` is the parameter's name in the document. */
export type BlockArgument = {
  readonly type: string;
  readonly name?: string;
  readonly key?: string;
  readonly check?: ValueType | readonly ValueType[];
  readonly shadow?: Shadow;
  readonly limits?: Limits;
} & Readonly<Record<string, unknown>>;

/** A block whose plus and minus buttons add and remove inputs; the inputs are A, B, ARG2, ... */
export interface Variadic {
  readonly check: ValueType | null;
  readonly min: number;
  readonly start: number;
  readonly shadow: Shadow | null;
}

/**
 * A row of the block table: Blockly's JSON of one block, its part of the document, its level in the
 * toolbox. `args0` follows the placeholders of the block's text; `%1` is the icon if the block has
 * one. Text and help are in `i18n/LANG/blocks.ts`, under the type in capitals.
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
  /** The loader creates this block from documents; the toolbox never offers it. */
  readonly hidden?: true;
}
