import * as Blockly from "blockly/core";
import { beforeAll, describe, expect, test } from "vitest";
import { textsOf } from "../i18n";
import { LANGUAGES } from "../i18n/languages";
import { ALL_DEFINITIONS, registerBlocks } from ".";
import { CATEGORY_COLOURS } from "./categories";
import type { BlockArgument, Level } from "./definition";
import { argumentsOf, categoryOf, type Row } from "./definitions";
import { VALUES } from "./generator/values";
import { sensorText } from "./sensor_text";
import { SENSOR_ROWS } from "./table/sensor_rows";
import type { TextKey } from "./texts";
import { setBlockLanguage } from "./texts";
import { searchBlocks } from "./toolbox/search";
import { flyoutBlocks, TOOLBOX_CATEGORIES, toolbox } from "./toolbox/toolbox";

beforeAll(() => {
  setBlockLanguage("pt-BR");
  registerBlocks();
});

const TYPES = ALL_DEFINITIONS.map(({ type }) => type);

/** A program with a function that has a parameter and returns a value. */
function programWithFunction(): Blockly.Workspace {
  const workspace = new Blockly.Workspace();
  const definition = workspace.newBlock("function_def");
  definition.loadExtraState?.({ parameters: ["lado"] });
  const result = workspace.newBlock("return_value").previousConnection;
  definition.nextConnection?.connect(result as Blockly.Connection);
  return workspace;
}

function offered(level: Level, actions: readonly string[] | null = null): string[] {
  const workspace = programWithFunction();
  return TOOLBOX_CATEGORIES.flatMap((name) =>
    flyoutBlocks(name, level, workspace, actions).map(({ type }) => type as string),
  );
}

const placeholders = (text: string) => (text.match(/%\d/g) ?? []).sort();

describe.each(ALL_DEFINITIONS.map((row) => [row.type, row] as const))("block %s", (type, row) => {
  test("is known to Blockly and draws itself with words and without a link to elsewhere", () => {
    const block = new Blockly.Workspace().newBlock(type);
    expect(block.toString()).not.toContain("BKY_");
    expect(Blockly.Tooltip.getTooltipOfObject(block)).not.toBe("");
    expect(block.helpUrl).toBe("");
    expect(block.getInputsInline()).toBe(true);
  });

  test("has a generator", () => {
    const { makes } = row;
    const isCommand = makes !== null && "action" in makes;
    expect(type in VALUES).toBe(row.output !== undefined);
    expect(isCommand).toBe(row.previousStatement === null);
  });

  test("stands in the toolbox from its level on, unless it is the start", () => {
    for (const level of [1, 2, 3] as const) {
      const expected = type !== "program_start" && !row.hidden && row.level <= level;
      expect(offered(level).includes(type), `level ${level}`).toBe(expected);
    }
  });

  test("has a hue that marks its category", () => {
    expect(["start", ...Object.keys(CATEGORY_COLOURS)]).toContain(row.style);
    if (row.makes && "action" in row.makes) expect(categoryOf(row.makes.action)).toBe(row.style);
  });
});

test("what comes out of the toolbox can be made, at every level", () => {
  for (const level of [1, 2, 3] as const) {
    for (const name of TOOLBOX_CATEGORIES) {
      const workspace = programWithFunction();
      for (const { kind: _, ...state } of flyoutBlocks(name, level, workspace)) {
        const block = Blockly.serialization.blocks.append(
          state as Blockly.serialization.blocks.State,
          workspace,
        );
        expect(block.toString()).not.toContain("BKY_");
      }
    }
  }
});

test("first steps are five categories, and everything is all of them", () => {
  const categories = (level: Level) =>
    toolbox(level)
      .contents.map((item) => (item as { id?: string }).id)
      .filter((id) => id !== "search");
  expect(categories(1)).toEqual(["motion", "flow", "logic", "gestures", "show"]);
  expect(categories(2)).not.toContain("functions");
  expect(categories(3)).toEqual(TOOLBOX_CATEGORIES);
});

test("explorers drive on until a sensor tells to stop", () => {
  expect(offered(2)).toEqual(
    expect.arrayContaining(["drive", "wait_until", "distance_sensor", "stop"]),
  );
  expect(offered(1)).not.toContain("drive");
});

describe("an activity that lists its commands", () => {
  const categories = (level: Level, actions: readonly string[]) =>
    toolbox(level, actions).contents.map((item) => (item as { id?: string }).id);

  test("offers these and no others, in their categories", () => {
    const few = ["move_forward", "turn", "pen"];
    expect(offered(1, few)).toEqual(["move_forward", "turn", "pen_down", "pen_up"]);
    expect(categories(1, few)).toEqual(["search", "motion", "show"]);
  });

  test("offers values of the first level with a command that has a condition", () => {
    const found = offered(1, ["classify_gestures", "conditional_execution"]);
    expect(found).toEqual(expect.arrayContaining(["if", "compare", "gesture_result"]));
    expect(found).not.toContain("floor");
  });

  test("offers a command of a higher level, and values of its own level", () => {
    const found = offered(2, ["go_to", "call"]);
    expect(found).toEqual(expect.arrayContaining(["go_to", "function_def", "call", "position"]));
    expect(offered(1, ["append"])).toEqual(["append"]);
  });

  test("is searched for what it offers", () => {
    const found = (query: string, actions: readonly string[] | null) =>
      searchBlocks(query, 1, new Blockly.Workspace(), actions).map(({ type }) => type);
    expect(found("girar", ["move_forward"])).toEqual([]);
    expect(found("girar", ["turn"])).toEqual(["turn"]);
    expect(found("girar", null)).toContain("turn");
  });
});

test("a hand is held to the limits of the place a number stands in", () => {
  for (const row of ALL_DEFINITIONS) {
    for (const { limits, shadow } of argumentsOf(row) as readonly BlockArgument[]) {
      if (!limits || !shadow || !("number" in shadow)) continue;
      const { min = -Infinity, max = Infinity } = limits;
      expect(shadow.number).toBeGreaterThanOrEqual(min);
      expect(shadow.number).toBeLessThanOrEqual(max);
    }
  }
});

describe.each(LANGUAGES)("texts in %s", (language) => {
  test.each(
    Object.entries(textsOf("pt-BR").blocks),
  )("%s says something with the same places", (key, text) => {
    const here = textsOf(language).blocks[key as TextKey];
    expect(here.trim()).not.toBe("");
    expect(placeholders(here)).toEqual(placeholders(text));
  });

  test("name every choice of every dropdown", () => {
    setBlockLanguage(language);
    const workspace = new Blockly.Workspace();
    for (const type of TYPES) {
      for (const input of workspace.newBlock(type).inputList) {
        for (const field of input.fieldRow) expect(field.getText()).not.toContain("BKY_");
      }
    }
  });
});

test("a sensor that is asked is called as on its block", () => {
  setBlockLanguage("en");
  expect(sensorText({ sensor: "sonar", index: 3 } as { sensor: string })).toBe("sonar 3 (m)");
  expect(sensorText({ sensor: "y" })).toBe("position y (m)");
  const front = { sensor: "distance", direction: "front" } as { sensor: string };
  expect(sensorText(front)).toBe("distance ahead (m)");
  for (const sensor of SENSOR_ROWS.flatMap((row) => row.sensors)) {
    expect(sensorText({ sensor })).not.toBe("");
  }
});

test("the number of places in a text is the number of arguments of its block", () => {
  for (const { type, args0, icon } of ALL_DEFINITIONS as readonly Row[]) {
    const text = textsOf("pt-BR").blocks[type.toUpperCase() as TextKey];
    expect(placeholders(text), type).toHaveLength(args0.length + (icon ? 1 : 0));
  }
});
