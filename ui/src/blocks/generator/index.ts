import type * as Blockly from "blockly/core";
import { definitionsIn, functionName, parametersOf } from "../names";
import { commentOf, generateStack } from "./commands";
import type { FunctionDefinition, ProgramDocument } from "./document";

export type { Command, ProgramDocument } from "./document";

/**
 * The program document of a workspace: the commands below the start block, and the functions in the
 * order of their creation. Loose blocks are ignored.
 */
export function generateDocument(workspace: Blockly.Workspace, name: string): ProgramDocument {
  const start = workspace.getBlocksByType("program_start", false)[0];
  return {
    pinel_ir: 1,
    name,
    functions: definitionsIn(workspace)
      .filter((definition) => !definition.isInsertionMarker())
      .map(generateFunction),
    commands: start ? generateStack(start.getNextBlock()) : [],
  };
}

function generateFunction(definition: Blockly.Block): FunctionDefinition {
  return {
    name: functionName(definition),
    parameters: parametersOf(definition),
    commands: generateStack(definition.getNextBlock()),
    block: definition.id,
    ...commentOf(definition),
  };
}
