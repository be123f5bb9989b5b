import * as Blockly from "blockly/core";
import { beforeAll, describe, expect, test } from "vitest";
import { registerBlocks } from "..";
import { ALL_DEFINITIONS } from "../definitions";
import { generateDocument } from "../generator";
import type { ProgramDocument } from "../generator/document";
import { setBlockLanguage } from "../texts";
import { workspaceOf } from ".";
import { RandomPrograms } from "./testing/random_programs";

beforeAll(() => {
  setBlockLanguage("pt-BR");
  registerBlocks();
});

function throughBlocks(document: object): ProgramDocument {
  const workspace = new Blockly.Workspace();
  Blockly.serialization.workspaces.load(workspaceOf(document), workspace);
  const saved = JSON.parse(JSON.stringify(Blockly.serialization.workspaces.save(workspace)));
  const again = new Blockly.Workspace();
  Blockly.serialization.workspaces.load(saved, again);
  const { name = "" } = document as Partial<ProgramDocument>;
  const made = generateDocument(again, name);
  workspace.dispose();
  again.dispose();
  return made;
}

describe("a document drawn at random from the whole language", () => {
  test.each(
    Array.from({ length: 300 }, (_, seed) => seed),
  )("%i is the same after a journey through blocks", (seed) => {
    const document = new RandomPrograms(seed).document();
    expect(throughBlocks(document)).toEqual(document);
  });

  test("has all of the actions, operators and sensors among them", () => {
    const text = Array.from({ length: 300 }, (_, seed) =>
      JSON.stringify(new RandomPrograms(seed).document()),
    ).join("");
    for (const action of ACTIONS) expect(text).toContain(`"action":"${action}"`);
    for (const op of OPERATORS) expect(text).toContain(`"op":"${op}"`);
    for (const sensor of SENSORS) expect(text).toContain(`"sensor":"${sensor}"`);
  });
});

/** The programs of the server's tests, in the normal form. */
const PROGRAMS = Object.entries(
  import.meta.glob<string>("../../../../tests/programs/blocks/*.json", {
    eager: true,
    query: "?raw",
    import: "default",
  }),
);

test("there are programs to try", () => expect(PROGRAMS.length).toBeGreaterThan(9));

test.each(
  PROGRAMS,
)("the program %s is the same after a journey through blocks, ids included", (_path, stored) => {
  const { document } = JSON.parse(stored);
  expect(throughBlocks(document)).toEqual(document);
});

test("ids of a document stay, and a second block of the same name gets another", () => {
  const stop = { action: "stop", block: "a" };
  const { commands } = throughBlocks({ pinel_ir: 1, name: "", commands: [stop, stop] });
  expect(commands[0]).toEqual(stop);
  expect(commands[1]?.block).not.toBe("a");
});

test("the same document is the same workspace, with a name for every block", () => {
  const document = new RandomPrograms(7).document();
  const workspace = workspaceOf(document);
  expect(workspaceOf(document)).toEqual(workspace);
  const opened = new Blockly.Workspace();
  Blockly.serialization.workspaces.load(workspace, opened);
  const saved = Blockly.serialization.workspaces.save(opened);
  const again = new Blockly.Workspace();
  Blockly.serialization.workspaces.load(workspaceOf(document), again);
  expect(Blockly.serialization.workspaces.save(again)).toEqual(saved);
});

test("a long list of commands is shown, too", () => {
  const commands = Array.from({ length: 1000 }, () => ({ action: "stop" }));
  expect(throughBlocks({ pinel_ir: 1, name: "", commands }).commands).toHaveLength(1000);
});

const MAKES = ALL_DEFINITIONS.flatMap(({ makes }) => makes ?? []);
const ACTIONS = MAKES.flatMap((makes) => ("action" in makes ? makes.action : []));
const OPERATORS = MAKES.flatMap((makes) => ("op" in makes ? makes.op : []));
const SENSORS = MAKES.flatMap((makes) => ("sensor" in makes ? makes.sensor : []));
