import { describe, expect, test } from "vitest";
import { MAX_SHOWN_COMMANDS, shownWorkspace, workspaceOf } from ".";

test("a workspace with blocks is shown as it was saved", () => {
  const saved = { blocks: { languageVersion: 0, blocks: [{ type: "stop", id: "a" }] } };
  expect(shownWorkspace(saved)).toBe(saved);
  expect(shownWorkspace({})).toEqual({});
});

describe("commands that came over HTTP", () => {
  test("are shown as blocks that keep their names", () => {
    const document = {
      pinel_ir: 1,
      commands: [{ action: "turn", angle: 90, block: "call-7" }],
    };
    expect(shownWorkspace({ document })).toEqual(workspaceOf(document));
    expect(JSON.stringify(shownWorkspace({ document }))).toContain('"id":"call-7"');
  });

  test("are not shown if no browser could show them", () => {
    const commands = Array(MAX_SHOWN_COMMANDS + 1).fill({ action: "stop" });
    expect(shownWorkspace({ document: { pinel_ir: 1, commands } })).toEqual({});
  });
});
