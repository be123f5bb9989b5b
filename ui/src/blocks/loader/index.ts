import type { FunctionDefinition, ProgramDocument } from "../generator/document";
import { commentIcon, stackOf } from "./commands";
import { below, MARGIN } from "./layout";
import { type BlockState, Ids } from "./state";

/**
 * Maximum number of commands shown as blocks. Blockly recurses over the blocks of a stack; with
 * more blocks it overflows the browser's stack, after half a minute without response.
 */
export const MAX_SHOWN_COMMANDS = 1500;

/** Number of commands in a document, nested ones included. */
export function commandCount(value: unknown): number {
  if (typeof value !== "object" || value === null) return 0;
  const own = "action" in value ? 1 : 0;
  return Object.values(value).reduce((sum: number, part) => sum + commandCount(part), own);
}

/**
 * The workspace that shows a document: its program, and below it one function after the other.
 * Expects the normal form, into which the server's reader converts each document. Blocks keep the
 * ids of the document; the same document always gives the same workspace.
 *
 * Throws if a command or value has no block, which cannot happen for a document without faults.
 */
export function workspaceOf(document: object): object {
  const { functions = [], commands } = document as ProgramDocument;
  const ids = new Ids();
  const next = stackOf(commands, ids);
  const start = { type: "program_start", id: "start", x: MARGIN, y: MARGIN, ...(next && { next }) };
  const blocks = [start, ...definitionBlocks(functions, below(MARGIN, commands), ids)];
  for (const block of blocks) ids.complete(block);
  return { blocks: { languageVersion: 0, blocks } };
}

/**
 * The workspace to show for a saved one. A program that came over HTTP was saved as `{ document }`;
 * its blocks are created from the document, unless it exceeds MAX_SHOWN_COMMANDS.
 */
export function shownWorkspace(saved: object): object {
  const { document } = saved as { document?: object };
  if (!document) return saved;
  return commandCount(document) > MAX_SHOWN_COMMANDS ? {} : workspaceOf(document);
}

function definitionBlocks(
  functions: readonly FunctionDefinition[],
  top: number,
  ids: Ids,
): BlockState[] {
  let y = top;
  return functions.map((definition) => {
    const { name, parameters = [], commands, block, comment } = definition;
    const next = stackOf(commands, ids);
    const state: BlockState = {
      type: "function_def",
      ...ids.claim(block),
      x: MARGIN,
      y,
      ...(parameters.length > 0 && { extraState: { parameters } }),
      ...commentIcon(comment),
      fields: { NAME: name },
      ...(next && { next }),
    };
    y = below(y, commands);
    return state;
  });
}
