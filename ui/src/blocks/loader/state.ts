import type * as Blockly from "blockly/core";

/** A block in Blockly's serialised form. */
export type BlockState = Blockly.serialization.blocks.State;

/** The content of an input: a block, a shadow block, or both. */
export type Connection = NonNullable<BlockState["inputs"]>[string];

/** Block ids: an id of the document is used for its first block; all other blocks get a number. */
export class Ids {
  private readonly used = new Set<string>(["start"]);
  private count = 0;

  /** The id that the document gives a block, unless another block has it already. */
  claim(id: unknown): { id?: string } {
    if (typeof id !== "string" || id === "" || this.used.has(id)) return {};
    this.used.add(id);
    return { id };
  }

  /**
   * Numbers the blocks without an id in the order of the program, so that equal documents give
   * equal workspaces.
   */
  complete(first: BlockState): void {
    for (let block: BlockState | undefined = first; block; block = block.next?.block) {
      block.id ??= this.next();
      for (const { block: inner, shadow } of Object.values(block.inputs ?? {})) {
        if (shadow) this.complete(shadow);
        if (inner) this.complete(inner);
      }
    }
  }

  private next(): string {
    let id: string;
    do id = `b${++this.count}`;
    while (this.used.has(id));
    return id;
  }
}
