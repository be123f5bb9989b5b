// Blocks that earlier versions of the page saved; see tests/compatibility/files/README.md.
import * as Blockly from "blockly/core";
import { beforeAll, expect, test } from "vitest";
import { registerBlocks } from "..";
import { generateDocument } from "../generator";
import { setBlockLanguage } from "../texts";

interface Saved {
  workspace: { blocks: object };
  document: { name: string };
}

const SAVED = Object.entries(
  import.meta.glob<Saved>("../../../../tests/compatibility/files/blocks/*.json", {
    eager: true,
    import: "default",
  }),
);

beforeAll(() => {
  setBlockLanguage("pt-BR");
  registerBlocks();
});

test.each(SAVED)("%s opens and makes the document that it made", (_path, saved) => {
  const workspace = new Blockly.Workspace();
  Blockly.serialization.workspaces.load(saved.workspace, workspace);
  expect(generateDocument(workspace, saved.document.name)).toEqual(saved.document);
  expect(Blockly.serialization.workspaces.save(workspace)).toEqual(saved.workspace);
  workspace.dispose();
});

test("they are there", () => {
  expect(SAVED).toHaveLength(3);
});
