import * as Blockly from "blockly/core";
import { beforeAll, describe, expect, test } from "vitest";
import { registerBlocks } from "..";
import { setBlockLanguage } from "../texts";
import { type Command, generateDocument } from ".";

beforeAll(() => {
  setBlockLanguage("pt-BR");
  registerBlocks();
});

type BlockState = Blockly.serialization.blocks.State;

const block = (type: string, id: string, rest: Partial<BlockState> = {}): BlockState => ({
  type,
  id,
  ...rest,
});
const number = (value: number) => ({ shadow: { type: "number", fields: { NUM: value } } });
const letter = (text: string, id: string) => block("text_letter", id, { fields: { TEXT: text } });
const compare = (operator: string, a?: BlockState, b?: BlockState) =>
  block("compare", "cmp", {
    fields: { OPERATOR: operator },
    inputs: { ...(a && { A: { block: a } }), ...(b && { B: { block: b } }) },
  });
const RESULT_IS_B = compare("==", block("gesture_result", "g"), letter("B", "l"));

function workspaceOf(...tops: BlockState[]): Blockly.Workspace {
  const workspace = new Blockly.Workspace();
  Blockly.serialization.workspaces.load(
    { blocks: { languageVersion: 0, blocks: tops } },
    workspace,
  );
  return workspace;
}

function commandsOf(first: BlockState): Command[] {
  const start = block("program_start", "start", { next: { block: first } });
  return generateDocument(workspaceOf(start), "teste").commands;
}

const CASES: [string, BlockState, Command][] = [
  [
    "move forward",
    block("move_forward", "a", { inputs: { DISTANCE: number(1.5) } }),
    { action: "move_forward", distance: 1.5, block: "a" },
  ],
  [
    "move backward",
    block("move_backward", "a", { inputs: { DISTANCE: number(0.25) } }),
    { action: "move_backward", distance: 0.25, block: "a" },
  ],
  [
    "a left turn as a positive angle",
    block("turn", "a", { fields: { DIRECTION: "LEFT" }, inputs: { ANGLE: number(90) } }),
    { action: "turn", angle: 90, block: "a" },
  ],
  [
    "a right turn as a negative angle",
    block("turn", "a", { fields: { DIRECTION: "RIGHT" }, inputs: { ANGLE: number(116.7) } }),
    { action: "turn", angle: -116.7, block: "a" },
  ],
  [
    "a right turn by nothing as plain zero",
    block("turn", "a", { fields: { DIRECTION: "RIGHT" }, inputs: { ANGLE: number(0) } }),
    { action: "turn", angle: 0, block: "a" },
  ],
  [
    "wait",
    block("wait", "a", { inputs: { SECONDS: number(2.5) } }),
    { action: "wait", seconds: 2.5, block: "a" },
  ],
  ["stop", block("stop", "a"), { action: "stop", block: "a" }],
  [
    "classify gestures",
    block("classify_gestures", "a", { inputs: { TIMEOUT: number(10) } }),
    { action: "classify_gestures", timeout: 10, block: "a" },
  ],
  [
    "read number",
    block("read_number", "a", { inputs: { TIMEOUT: number(5) } }),
    { action: "read_number", timeout: 5, block: "a" },
  ],
  [
    "as many metres as fingers",
    block("move_forward", "a", { inputs: { DISTANCE: { block: block("number_shown", "n") } } }),
    { action: "move_forward", distance: { gesture: "number" }, block: "a" },
  ],
  [
    "set gesture result",
    block("set_gesture_result", "a", { inputs: { RESULT: { shadow: letter("L", "l") } } }),
    { action: "set_gesture_result", result: "L", block: "a" },
  ],
  [
    "an empty repeat",
    block("repeat", "a", { inputs: { TIMES: number(3) } }),
    { action: "repeat", times: 3, commands: [], block: "a" },
  ],
  [
    "repeats inside each other",
    block("repeat", "a", {
      inputs: {
        TIMES: number(2),
        DO: {
          block: block("repeat", "b", {
            inputs: { TIMES: number(4), DO: { block: block("stop", "c") } },
          }),
        },
      },
    }),
    {
      action: "repeat",
      times: 2,
      block: "a",
      commands: [
        {
          action: "repeat",
          times: 4,
          block: "b",
          commands: [{ action: "stop", block: "c" }],
        },
      ],
    },
  ],
  [
    "if with its condition as a tree",
    block("if", "a", {
      inputs: { CONDITION: { block: RESULT_IS_B }, THEN: { block: block("stop", "b") } },
    }),
    {
      action: "conditional_execution",
      condition: { op: "==", args: [{ gesture: "result" }, "B"] },
      commands: [{ action: "stop", block: "b" }],
      block: "a",
    },
  ],
  [
    "if and else",
    block("if", "a", {
      extraState: { else: true },
      inputs: { CONDITION: { block: RESULT_IS_B }, ELSE: { block: block("stop", "b") } },
    }),
    {
      action: "conditional_execution",
      condition: { op: "==", args: [{ gesture: "result" }, "B"] },
      commands: [],
      else: [{ action: "stop", block: "b" }],
      block: "a",
    },
  ],
  [
    "an if without a condition without the key, for the reader to fault",
    block("if", "a"),
    { action: "conditional_execution", commands: [], block: "a" },
  ],
  [
    "a comparison with an empty side with fewer arguments",
    block("if", "a", { inputs: { CONDITION: { block: compare("!=", letter("A", "l")) } } }),
    {
      action: "conditional_execution",
      condition: { op: "!=", args: ["A"] },
      commands: [],
      block: "a",
    },
  ],
  [
    "and, or, not",
    block("if", "a", {
      inputs: {
        CONDITION: {
          block: block("logic_operation", "o", {
            fields: { OPERATOR: "or" },
            inputs: {
              A: { block: block("not", "n", { inputs: { A: { block: RESULT_IS_B } } }) },
              B: { block: compare("!=", letter("A", "x"), letter("a", "y")) },
            },
          }),
        },
      },
    }),
    {
      action: "conditional_execution",
      condition: {
        op: "or",
        args: [
          { op: "not", args: [{ op: "==", args: [{ gesture: "result" }, "B"] }] },
          { op: "!=", args: ["A", "a"] },
        ],
      },
      commands: [],
      block: "a",
    },
  ],
];

describe("the generator", () => {
  test.each(CASES)("writes %s", (_name, state, command) => {
    expect(commandsOf(state)).toEqual([command]);
  });

  test("keeps the order of a stack", () => {
    const stack = block("stop", "a", {
      next: { block: block("wait", "b", { next: { block: block("stop", "c") } }) },
    });
    expect(commandsOf(stack).map((command) => command.block)).toEqual(["a", "b", "c"]);
  });

  test("gives the document its name and version", () => {
    const document = generateDocument(workspaceOf(block("program_start", "start")), "quadrado");
    expect(document).toEqual({ pinel_ir: 1, name: "quadrado", functions: [], commands: [] });
  });

  test("leaves loose blocks out", () => {
    const workspace = workspaceOf(
      block("stop", "loose"),
      block("program_start", "start", { next: { block: block("stop", "a") } }),
      letter("B", "lost"),
    );
    expect(generateDocument(workspace, "").commands).toEqual([{ action: "stop", block: "a" }]);
  });

  test("writes 2,000 blocks in a row", () => {
    let stack = block("stop", "s0");
    for (let index = 1; index < 2000; index++) {
      stack = block("stop", `s${index}`, { next: { block: stack } });
    }
    expect(commandsOf(stack)).toHaveLength(2000);
  });

  test("writes the same after saving and loading, ids included", () => {
    const start = block("program_start", "start", {
      next: { block: CASES[11]?.[1] as BlockState },
    });
    const workspace = workspaceOf(start, block("stop", "loose"));
    const saved = Blockly.serialization.workspaces.save(workspace);
    const again = new Blockly.Workspace();
    Blockly.serialization.workspaces.load(JSON.parse(JSON.stringify(saved)), again);
    expect(Blockly.serialization.workspaces.save(again)).toEqual(saved);
    expect(generateDocument(again, "x")).toEqual(generateDocument(workspace, "x"));
    expect(again.getAllBlocks().map(({ id }) => id)).toContain("loose");
  });
});
