/**
 * What a definition file holds: Blockly's JSON of one block without its words, which `index.ts` adds from `texts/`.
 * `args0` follows the placeholders of the block's text; by convention `%1` is its icon where it has one.
 */
export interface BlockDefinition {
  readonly type: string;
  readonly style: string;
  readonly args0: readonly BlockArgument[];
  readonly message1?: string;
  readonly args1?: readonly BlockArgument[];
  readonly message2?: string;
  readonly args2?: readonly BlockArgument[];
  readonly message3?: string;
  readonly args3?: readonly BlockArgument[];
  readonly output?: ValueType;
  readonly previousStatement?: null;
  readonly nextStatement?: null;
  readonly inputsInline?: boolean;
  readonly hat?: "cap";
  readonly extensions?: readonly string[];
}

/** What a value block gives and what an input accepts. */
export type ValueType = "Boolean" | "Text";

export type BlockArgument = { readonly type: string; readonly name?: string } & Readonly<
  Record<string, unknown>
>;
