// The programs of the server's tests as blocks. tests/programs/blocks/NAME.json holds the workspace
// and the generated document; tests/test_programs.py runs the document. UPDATE_PROGRAMS=1 rewrites
// the files. Programs in the format of the original are not rewritten: only the server's reader
// knows that format.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import * as Blockly from "blockly/core";
import { beforeAll, describe, expect, test } from "vitest";
import { registerBlocks } from "..";
import { generateDocument } from "../generator";
import { setBlockLanguage } from "../texts";
import { workspaceOf } from ".";

const FOLDER = `${process.cwd()}/../tests/programs/blocks/`; // vitest runs in ui/
const PROGRAMS = Object.entries(
  import.meta.glob<{ name?: string }>("../../../../tests/programs/*.json", {
    eager: true,
    import: "default",
  }),
).filter(([path]) => !path.includes(".values."));

const OF_THE_ORIGINAL = /\/(b_or_a|b_or_a_not_recognised|else_and_elif)\.json$/;

beforeAll(() => {
  setBlockLanguage("pt-BR");
  registerBlocks();
  mkdirSync(FOLDER, { recursive: true });
});

/** The content that the page stores: the workspace, each block with an id, and the document. */
function stored(workspace: object, name: string): { workspace: object; document: object } {
  const trial = new Blockly.Workspace();
  Blockly.serialization.workspaces.load(workspace, trial);
  const content = {
    workspace: Blockly.serialization.workspaces.save(trial),
    document: generateDocument(trial, name),
  };
  trial.dispose();
  return content;
}

describe.each(PROGRAMS)("%s", (path, program) => {
  const file = FOLDER + (path.split("/").at(-1) ?? "");

  test("is kept as blocks that make the document kept beside them", () => {
    const name = program.name ?? "";
    if (process.env.UPDATE_PROGRAMS && !OF_THE_ORIGINAL.test(path)) {
      writeFileSync(file, `${JSON.stringify(stored(workspaceOf(program), name), null, 1)}\n`);
    }
    const { workspace, document } = JSON.parse(readFileSync(file, "utf-8"));
    expect(stored(workspace, name).document).toEqual(document);
  });
});
