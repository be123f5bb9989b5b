import type * as Blockly from "blockly/core";
import type { StatementBlockType } from "../blocks/definitions";
import { COMMANDS } from "./commands";
import type { Command, ProgramDocument } from "./document";

export type { Command, ProgramDocument } from "./document";

/** What the robot gets: the commands below the start block. Loose blocks stay out. */
export function generateDocument(workspace: Blockly.Workspace, name: string): ProgramDocument {
  const start = workspace.getBlocksByType("program_start", true)[0];
  const commands = start ? generateStack(start.getNextBlock()) : [];
  return { pinel_ir: 1, name, functions: [], commands };
}

/** The commands of a stack of blocks, from its first block down. */
export function generateStack(first: Blockly.Block | null): Command[] {
  const commands: Command[] = [];
  for (let block = first; block; block = block.getNextBlock()) {
    if (!block.isInsertionMarker()) commands.push(generateCommand(block));
  }
  return commands;
}

function generateCommand(block: Blockly.Block): Command {
  const parameters = COMMANDS[block.type as StatementBlockType](block, (input) =>
    generateStack(block.getInputTargetBlock(input)),
  );
  return { ...parameters, block: block.id };
}
