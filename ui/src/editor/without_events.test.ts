import * as Blockly from "blockly/core";
import { beforeAll, expect, test } from "vitest";
import { registerBlocks } from "../blocks";
import { setBlockLanguage } from "../blocks/texts";
import { withoutEvents } from "./without_events";

beforeAll(() => {
  setBlockLanguage("pt-BR");
  registerBlocks();
});

function load(type: string): void {
  const saved = { blocks: { languageVersion: 0, blocks: [{ type }] } };
  Blockly.serialization.workspaces.load(saved, new Blockly.Workspace());
}

test("a program of a newer version, which cannot be opened, leaves undo to the next one", () => {
  expect(() => withoutEvents(() => load("a_block_of_the_future"))).toThrow();
  expect(Blockly.Events.getRecordUndo()).toBe(true);
  expect(Blockly.Events.isEnabled()).toBe(true);
  expect(Blockly.Events.getGroup()).toBe("");
});

test("a program that can be opened fires no events", () => {
  const events: string[] = [];
  const workspace = new Blockly.Workspace();
  workspace.addChangeListener(({ type }) => events.push(type));
  withoutEvents(() => workspace.newBlock("stop"));
  expect(events).toEqual([]);
  expect(workspace.getAllBlocks(false)).toHaveLength(1);
});
