import type * as Blockly from "blockly/core";

export type Literal = number | string | boolean;

interface ListBlock extends Blockly.Block {
  values: readonly Literal[];
}

/** A list that is too long to show every value. */
const mixin = {
  values: [] as readonly Literal[],

  saveExtraState(this: ListBlock): { values: readonly Literal[] } {
    return { values: this.values };
  },

  loadExtraState(this: ListBlock, state: { values?: readonly Literal[] }): void {
    this.values = state.values ?? [];
    this.setFieldValue(String(this.values.length), "COUNT");
  },
};

export function valuesOf(block: Blockly.Block): readonly Literal[] {
  return (block as ListBlock).values;
}

export const listData = [mixin] as const;
