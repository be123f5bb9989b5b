import type * as Blockly from "blockly/core";

/** A block as Blockly keeps it. */
export type BlockState = Blockly.serialization.blocks.State;

/** What stands in an input. */
export type Connection = NonNullable<BlockState["inputs"]>[string];

/** Ids of a document's blocks are kept, each once; other blocks get theirs from Blockly. */
export class Ids {
  private readonly used = new Set<string>(["start"]);

  take(id: unknown): { id?: string } {
    if (typeof id !== "string" || id === "" || this.used.has(id)) return {};
    this.used.add(id);
    return { id };
  }
}
