import type { FunctionDefinition, ProgramDocument } from "../generator/document";
import { commentIcon, stackOf } from "./commands";
import { below, MARGIN } from "./layout";
import { type BlockState, Ids } from "./state";

/**
 * What can be shown as blocks: Blockly calls itself for each block under another, and with more of them the browser's
 * stack is not enough, after half a minute of nothing happening.
 */
export const MAX_SHOWN_COMMANDS = 1500;

/** How many commands a document has, wherever they stand. */
export function commandCount(value: unknown): number {
  if (typeof value !== "object" || value === null) return 0;
  const own = "action" in value ? 1 : 0;
  return Object.values(value).reduce((sum: number, part) => sum + commandCount(part), own);
}

/**
 * The workspace that shows a document: its program, and below it its functions one after the other. Takes documents
 * in the normal form, which the server's reader makes of all that it takes. What a document's blocks are called they
 * keep, and the same document is always the same workspace.
 *
 * Throws where a block cannot be shown, which for a document without faults does not happen.
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
 * A saved workspace as it is shown. What came as commands over HTTP was saved as `{ document }`: it has its blocks from
 * there, unless they are too many to be shown.
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
