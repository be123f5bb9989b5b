import * as Blockly from "blockly/core";
import { beforeAll, beforeEach, describe, expect, test } from "vitest";
import { registerBlocks } from "..";
import { functionName, namesFor, parametersOf, renameVariable, variableNames } from "../names";
import { setBlockLanguage } from "../texts";
import { callOf } from "./call";
import { syncCalls } from "./function_sync";

type State = Blockly.serialization.blocks.State;
interface Shaped extends Blockly.Block {
  plus(): void;
  minus(index?: number): void;
  minusElif(index: number): void;
  minusElse(): void;
}

beforeAll(registerBlocks);
beforeEach(() => setBlockLanguage("pt-BR"));

let workspace: Blockly.Workspace;
beforeEach(() => {
  workspace = new Blockly.Workspace();
  syncCalls(workspace);
});

function add(state: State): Shaped {
  return Blockly.serialization.blocks.append(state, workspace, { recordUndo: true }) as Shaped;
}

/** Waits until Blockly has fired its delayed events, and the events that their listeners cause. */
async function settled(): Promise<void> {
  for (let round = 0; round < 3; round++) await new Promise((done) => setTimeout(done, 25));
}

/** Starts a new undo history. */
async function fromHere(): Promise<void> {
  await settled();
  workspace.clearUndo();
}

const inputs = (block: Blockly.Block) =>
  block.inputList.map(({ name }) => name).filter((name) => /^[A-Z]+\d*$/.test(name));

describe("an if", () => {
  const branch = (text: string): NonNullable<State["inputs"]>[string] => ({
    block: { type: "say", inputs: { TEXT: { shadow: { type: "text", fields: { TEXT: text } } } } },
  });
  const textIn = (block: Blockly.Block, input: string) =>
    block.getInputTargetBlock(input)?.getInputTargetBlock("TEXT")?.getFieldValue("TEXT");

  test("gets an else first, then one else if after the other", () => {
    const block = add({ type: "if" });
    block.plus();
    expect(block.saveExtraState?.()).toEqual({ else: true });
    block.plus();
    block.plus();
    expect(block.saveExtraState?.()).toEqual({ elif: 2, else: true });
    expect(inputs(block).filter((name) => name.startsWith("THEN") || name === "ELSE")).toEqual([
      "THEN",
      "THEN1",
      "THEN2",
      "ELSE",
    ]);
  });

  test("loses the branch that is taken away, and only that", async () => {
    const block = add({
      type: "if",
      extraState: { elif: 2, else: true },
      inputs: { THEN1: branch("um"), THEN2: branch("dois"), ELSE: branch("fim") },
    });
    await fromHere();
    block.minusElif(1);
    expect(block.saveExtraState?.()).toEqual({ elif: 1, else: true });
    expect([textIn(block, "THEN1"), textIn(block, "ELSE")]).toEqual(["dois", "fim"]);

    await settled();
    workspace.undo(false);
    expect(block.saveExtraState?.()).toEqual({ elif: 2, else: true });
    expect([textIn(block, "THEN1"), textIn(block, "THEN2")]).toEqual(["um", "dois"]);

    workspace.undo(true);
    expect(textIn(block, "THEN1")).toBe("dois");
  });

  test("can do without its else", () => {
    const block = add({ type: "if", extraState: { else: true } });
    block.minusElse();
    expect(block.saveExtraState?.()).toBeNull();
    expect(block.getInput("ELSE")).toBeNull();
  });
});

describe("a block that takes more and more", () => {
  test.each([
    ["list_of", 0],
    ["join", 1],
    ["min_max", 1],
    ["logic_operation", 2],
  ])("%s keeps %i places at least", (type, min) => {
    const block = add({ type });
    for (let times = 0; times < 5; times++) {
      if (block.getInput("BUTTONS")?.fieldRow.length === 2) block.minus();
    }
    expect(inputs(block).filter((name) => name !== "BUTTONS")).toHaveLength(min);
    block.plus();
    expect(inputs(block).filter((name) => name !== "BUTTONS")).toHaveLength(min + 1);
  });

  test("says its operator between all of its values", () => {
    const block = add({ type: "logic_operation", extraState: { n: 3 } });
    block.setFieldValue("or", "OPERATOR");
    expect(block.getFieldValue("BETWEEN2")).toBe("ou");
  });

  test("gets back with undo what was taken away", async () => {
    const block = add({
      type: "list_of",
      inputs: { ARG2: { block: { type: "text", id: "t", fields: { TEXT: "azul" } } } },
    });
    await fromHere();
    block.minus();
    await settled();
    expect(block.getInput("ARG2")).toBeNull();
    workspace.undo(false);
    expect(block.getInputTargetBlock("ARG2")?.id).toBe("t");
  });

  test("takes only what is written out into a list", () => {
    const list = add({ type: "list_of" });
    const variable = add({ type: "variable" });
    const { connectionChecker } = workspace;
    const place = list.getInput("A")?.connection as Blockly.Connection;
    expect(connectionChecker.canConnect(variable.outputConnection, place, false)).toBe(false);
  });
});

describe("checks", () => {
  test.each<[string, string, string, boolean]>([
    ["move_forward", "DISTANCE", "number", true],
    ["move_forward", "DISTANCE", "variable", true],
    ["move_forward", "DISTANCE", "call_value", true],
    ["move_forward", "DISTANCE", "distance_sensor", true],
    ["move_forward", "DISTANCE", "text", false],
    ["move_forward", "DISTANCE", "compare", false],
    ["while", "CONDITION", "compare", true],
    ["while", "CONDITION", "variable", true],
    ["while", "CONDITION", "arithmetic", false],
    ["length", "A", "list_of", true],
    ["length", "A", "text", true],
    ["length", "A", "number", false],
    ["item", "LIST", "list_of", true],
    ["item", "LIST", "text", false],
    ["set_variable", "VALUE", "list_of", true],
    ["say", "TEXT", "compare", true],
  ])("%s %s and a %s: %s", (type, input, value, fits) => {
    const place = add({ type }).getInput(input)?.connection as Blockly.Connection;
    const output = add({ type: value }).outputConnection;
    expect(workspace.connectionChecker.canConnect(output, place, false)).toBe(fits);
  });
});

describe("a function", () => {
  const call = (): State => ({
    type: "call",
    extraState: { name: "polígono", parameters: ["lados", "lado"] },
    inputs: {
      ARG0: { shadow: { type: "number", fields: { NUM: 5 } } },
      ARG1: { shadow: { type: "number" }, block: { type: "variable", fields: { NAME: "lado" } } },
    },
  });
  const define = () =>
    add({
      type: "function_def",
      extraState: { parameters: ["lados", "lado"] },
      fields: { NAME: "polígono" },
      next: {
        block: {
          type: "move_forward",
          inputs: {
            DISTANCE: { block: { type: "variable", id: "use", fields: { NAME: "lado" } } },
          },
        },
      },
    });
  const value = (block: Blockly.Block, input: string) => {
    const inside = block.getInputTargetBlock(input);
    return inside?.getFieldValue("NUM") ?? inside?.getFieldValue("NAME");
  };

  test("that gets another name is called by that name", async () => {
    const definition = define();
    const caller = add(call());
    await fromHere();
    definition.setFieldValue("figura", "NAME");
    await settled();
    expect(callOf(caller).name).toBe("figura");
    workspace.undo(false);
    await settled();
    expect([functionName(definition), callOf(caller).name]).toEqual(["polígono", "polígono"]);
  });

  test("whose parameter gets another name uses it by that name, and calls keep their values", async () => {
    const definition = define();
    const caller = add(call());
    await fromHere();
    definition.setFieldValue("tamanho", "PARAM1");
    await settled();
    expect(workspace.getBlockById("use")?.getFieldValue("NAME")).toBe("tamanho");
    expect(callOf(caller).parameters).toEqual(["lados", "tamanho"]);
    // the call uses a variable that only happens to have the parameter's old name
    expect([value(caller, "ARG0"), value(caller, "ARG1")]).toEqual([5, "lado"]);
  });

  test("that loses a parameter takes it from its calls, and undo gives it back", async () => {
    const definition = define();
    const caller = add(call());
    await fromHere();
    definition.minus(0);
    await settled();
    expect(parametersOf(definition)).toEqual(["lado"]);
    expect(callOf(caller).parameters).toEqual(["lado"]);
    expect(value(caller, "ARG0")).toBe("lado");

    workspace.undo(false);
    await settled();
    expect(parametersOf(definition)).toEqual(["lados", "lado"]);
    expect(callOf(caller).parameters).toEqual(["lados", "lado"]);
    expect(value(caller, "ARG1")).toBe("lado");
  });

  test("that gets a parameter asks for it where it is called", async () => {
    const definition = define();
    const caller = add(call());
    await fromHere();
    definition.plus();
    await settled();
    expect(callOf(caller).parameters).toEqual(["lados", "lado", "valor"]);
    expect(value(caller, "ARG2")).toBe(0);
  });

  test.each(["", "  ", "a-b", "x".repeat(65)])("is never called %j", (name) => {
    const definition = define();
    definition.setFieldValue(name, "NAME");
    expect(functionName(definition)).toBe("polígono");
  });

  test("has a name of its own, also as a copy", async () => {
    define();
    await settled();
    const copy = define();
    await settled();
    expect(functionName(copy)).toBe("polígono 2");
    copy.setFieldValue("polígono", "NAME");
    expect(functionName(copy)).toBe("polígono 2");
  });

  test("has parameters that differ", () => {
    const definition = define();
    definition.setFieldValue("lados", "PARAM1");
    expect(parametersOf(definition)).toEqual(["lados", "lado"]);
  });

  test("keeps its parameters to itself", () => {
    const definition = define();
    const outside = add({ type: "set_variable", fields: { NAME: "lado" } });
    const inside = workspace.getBlockById("use") as Blockly.Block;
    expect(namesFor(inside)).toEqual(["lado", "lados"]);
    expect(variableNames(workspace)).toEqual(["lado"]);
    renameVariable(outside, "lado", "aresta");
    expect(inside.getFieldValue("NAME")).toBe("lado");
    renameVariable(inside, "lado", "tamanho");
    expect(parametersOf(definition)).toEqual(["lados", "tamanho"]);
    expect(inside.getFieldValue("NAME")).toBe("tamanho");
    expect(outside.getFieldValue("NAME")).toBe("aresta");
  });
});

test("a number keeps to the limits of its place only under a hand", () => {
  const sonar = add({
    type: "sonar",
    inputs: { INDEX: { shadow: { type: "number", fields: { NUM: 99 } } } },
  });
  const index = sonar.getInputTargetBlock("INDEX") as Blockly.Block;
  expect(index.getFieldValue("NUM")).toBe(99);
  index.setFieldValue("17", "NUM");
  expect(index.getFieldValue("NUM")).toBe(15);
  index.setFieldValue("2,6", "NUM");
  expect(index.getFieldValue("NUM")).toBe(3);
});
