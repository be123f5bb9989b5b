// Documents to blocks and back, for tests of the server. PINEL_EXCHANGE names a file with a list of
// documents; the test writes the generated documents to NAME.out beside it. Without PINEL_EXCHANGE
// the test uses three random programs.
import { readFileSync, writeFileSync } from "node:fs";
import * as Blockly from "blockly/core";
import { beforeAll, expect, test } from "vitest";
import { registerBlocks } from "..";
import { generateDocument } from "../generator";
import { setBlockLanguage } from "../texts";
import { commandCount, workspaceOf } from ".";
import { RandomPrograms } from "./testing/random_programs";

const FILE = process.env.PINEL_EXCHANGE;

beforeAll(() => {
  setBlockLanguage("pt-BR");
  registerBlocks();
});

function throughBlocks(document: { name?: string }): object {
  const workspace = new Blockly.Workspace();
  Blockly.serialization.workspaces.load(workspaceOf(document), workspace);
  const made = generateDocument(workspace, document.name ?? "");
  workspace.dispose();
  return made;
}

// a file may hold many documents; the server's test that wrote the file has its own time limit
test("documents go through blocks and come back", { timeout: 120_000 }, () => {
  const documents: { name?: string }[] = FILE
    ? JSON.parse(readFileSync(FILE, "utf-8"))
    : [1, 2, 3].map((seed) => new RandomPrograms(seed).document());
  const made = documents.map(throughBlocks);
  if (FILE) writeFileSync(`${FILE}.out`, JSON.stringify(made));
  else expect(made).toEqual(documents);
});

test("commands are counted wherever they stand", () => {
  const move = { action: "move_forward", distance: 1 };
  const loop = { action: "repeat", times: 2, commands: [move, move] };
  const choice = {
    action: "conditional_execution",
    condition: true,
    commands: [move],
    elif: [{ condition: false, commands: [move] }],
    else: [loop],
  };
  expect(commandCount([move, loop])).toBe(4);
  expect(commandCount({ commands: [choice], functions: [{ name: "f", commands: [move] }] })).toBe(
    7,
  );
  expect(commandCount({ commands: [] })).toBe(0);
});
