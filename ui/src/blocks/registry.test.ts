import * as Blockly from "blockly/core";
import { beforeAll, describe, expect, test } from "vitest";
import { COMMANDS } from "../generator/commands";
import { VALUES } from "../generator/values";
import { LANGUAGES } from "../i18n/language";
import { ALL_DEFINITIONS, registerBlocks } from ".";
import { BLOCK_TEXTS, setBlockLanguage } from "./texts";
import type { TextKey } from "./texts/keys";
import { toolbox } from "./toolbox";

beforeAll(() => {
  setBlockLanguage("pt-BR");
  registerBlocks();
});

const TYPES = ALL_DEFINITIONS.map(({ type }) => type);

function toolboxTypes(): string[] {
  return toolbox().contents.flatMap((category) =>
    (category as { contents: { type: string }[] }).contents.map(({ type }) => type),
  );
}

const placeholders = (text: string) => (text.match(/%\d/g) ?? []).sort();

describe.each(TYPES)("block %s", (type) => {
  test("is known to Blockly and draws itself with words and without a link to elsewhere", () => {
    const block = new Blockly.Workspace().newBlock(type);
    expect(block.toString()).not.toContain("BKY_");
    expect(Blockly.Tooltip.getTooltipOfObject(block)).not.toBe("");
    expect(block.helpUrl).toBe("");
  });

  test("has a generator", () => {
    expect(type === "program_start" || type in COMMANDS || type in VALUES).toBe(true);
  });

  test("stands in the toolbox once, unless it is the start", () => {
    const places = toolboxTypes().filter((place) => place === type);
    expect(places).toHaveLength(type === "program_start" ? 0 : 1);
  });
});

describe.each(LANGUAGES)("texts in %s", (language) => {
  test.each(
    Object.entries(BLOCK_TEXTS["pt-BR"]),
  )("%s says something with the same places", (key, text) => {
    const here = BLOCK_TEXTS[language][key as TextKey];
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

test("the number of places in a text is the number of arguments of its block", () => {
  for (const { type, args0 } of ALL_DEFINITIONS) {
    const text = BLOCK_TEXTS["pt-BR"][type.toUpperCase() as TextKey];
    expect(placeholders(text), type).toHaveLength(args0.length);
  }
});
