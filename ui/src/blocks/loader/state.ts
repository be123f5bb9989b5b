import type * as Blockly from "blockly/core";

/** A block as Blockly keeps it. */
export type BlockState = Blockly.serialization.blocks.State;

/** What stands in an input. */
export type Connection = NonNullable<BlockState["inputs"]>[string];

/** Names for blocks: those of the document are kept, each once; other blocks are counted. */
export class Ids {
  private readonly used = new Set<string>(["start"]);
  private count = 0;

  /** The name that a document gives a block, unless another has it. */
  claim(id: unknown): { id?: string } {
    if (typeof id !== "string" || id === "" || this.used.has(id)) return {};
    this.used.add(id);
    return { id };
  }

  /** Names what has no name yet, in the order of the program, so that the same document is the same workspace. */
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
