import * as Blockly from "blockly/core";
import { beforeAll, beforeEach, describe, expect, test } from "vitest";
import type { Language } from "../../i18n";
import { registerBlocks } from "..";
import type { Level } from "../definition";
import { setBlockLanguage } from "../texts";
import { searchBlocks } from "./search";

beforeAll(registerBlocks);
beforeEach(() => setBlockLanguage("pt-BR"));

function found(query: string, level: Level = 3, workspace = new Blockly.Workspace()): string[] {
  return searchBlocks(query, level, workspace).map(({ type }) => type as string);
}

describe("the search", () => {
  test.each<[string, string, Language]>([
    ["andar", "move_forward", "pt-BR"],
    ["ATRÁS", "distance_sensor", "pt-BR"],
    ["tras", "move_backward", "pt-BR"],
    ["nao", "not", "pt-BR"],
    ["sinal lido", "gesture_result", "pt-BR"],
    ["lido gest", "gesture_result", "pt-BR"],
    ["dedos", "read_number", "pt-BR"],
    ["número mostrado", "number_shown", "pt-BR"],
    ["fingers", "read_number", "en"],
    ["raiz", "math_function", "pt-BR"],
    ["vermelho", "pen_down", "pt-BR"],
    ["repeat", "repeat", "en"],
    ["square root", "math_function", "en"],
    ["angulo", "lidar", "es"],
    ["×", "arithmetic", "pt-BR"],
  ])("for %j finds %s (%s)", (query, type, language) => {
    setBlockLanguage(language);
    expect(found(query)).toContain(type);
  });

  test("puts blocks that say the words before those whose help says them", () => {
    const types = found("repetir");
    expect(types.slice(0, 4)).toEqual(["repeat", "forever", "while", "until"]);
  });

  test.each(["", "   ", "xyzw", "andar xyzw"])("finds nothing for %j", (query) => {
    expect(found(query)).toEqual([]);
  });

  test("offers only what the level offers", () => {
    expect(found("sonar", 1)).toEqual([]);
    expect(found("sonar", 3)).toContain("sonar");
  });

  test("finds the functions of the program by their names", () => {
    const workspace = new Blockly.Workspace();
    const definition = workspace.newBlock("function_def");
    definition.setFieldValue("polígono", "NAME");
    expect(found("poligono", 3, workspace)).toEqual(["call"]);

    const result = workspace.newBlock("return_value").previousConnection;
    definition.nextConnection?.connect(result as Blockly.Connection);
    expect(found("poligono", 3, workspace)).toEqual(["call", "call_value"]);
  });
});
