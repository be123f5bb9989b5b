import * as Blockly from "blockly/core";
import { beforeAll, describe, expect, test } from "vitest";
import { registerBlocks } from "..";
import { generateDocument } from "../generator";
import { MOST_SHOWN } from "../loader";
import { setBlockLanguage } from "../words";
import { upgradeWorkspace } from ".";
import saved from "./saved_by_0_1.json";

beforeAll(() => {
  setBlockLanguage("pt-BR");
  registerBlocks();
});

function opened(workspace: object): Blockly.Workspace {
  const made = new Blockly.Workspace();
  Blockly.serialization.workspaces.load(workspace, made);
  return made;
}

describe("a workspace that version 0.1 saved", () => {
  test("opens and is the same program, block by block", () => {
    const workspace = opened(upgradeWorkspace(saved.workspace));
    expect(generateDocument(workspace, "letra")).toEqual(saved.document);
  });

  test("keeps its loose blocks", () => {
    const workspace = opened(upgradeWorkspace(saved.workspace));
    expect(workspace.getTopBlocks(true).map(({ type }) => type)).toEqual(["program_start", "turn"]);
  });

  test("is the same workspace every time it is opened", () => {
    const save = () =>
      Blockly.serialization.workspaces.save(opened(upgradeWorkspace(saved.workspace)));
    expect(save()).toEqual(save());
  });

  test("is not changed by being upgraded", () => {
    const before = structuredClone(saved.workspace);
    upgradeWorkspace(saved.workspace);
    expect(saved.workspace).toEqual(before);
  });
});

test("a workspace of this version stays as it is", () => {
  const workspace = Blockly.serialization.workspaces.save(
    opened(upgradeWorkspace(saved.workspace)),
  );
  expect(upgradeWorkspace(workspace)).toEqual(workspace);
  expect(upgradeWorkspace({})).toEqual({});
});

describe("commands that came over HTTP", () => {
  const turn = { action: "turn", angle: 90, block: "call-7" };

  test("are shown as blocks that keep their names", () => {
    const blocks = opened(upgradeWorkspace({ document: { pinel_ir: 1, commands: [turn] } }));
    expect(blocks.getBlockById("call-7")?.type).toBe("turn");
  });

  test("are not shown if no browser could show them", () => {
    const commands = Array(MOST_SHOWN + 1).fill({ action: "stop" });
    expect(upgradeWorkspace({ document: { pinel_ir: 1, commands } })).toEqual({});
  });
});

test("a block saved without its fields gets what it held to begin with", () => {
  const bare = { blocks: { blocks: [{ type: "turn", id: "t" }] } };
  const [turn] = opened(upgradeWorkspace(bare)).getTopBlocks(false);
  expect(turn?.getInputTargetBlock("ANGLE")?.getFieldValue("NUM")).toBe(90);
});
