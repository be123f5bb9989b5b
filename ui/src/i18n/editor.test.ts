import * as blockly from "blockly/msg/en";
import { expect, test } from "vitest";
import { textsOf } from ".";
import { LANGUAGES } from "./languages";
import { editor as ptBR } from "./pt-BR/editor";

test("every message of our own is one that Blockly knows, with the same places", () => {
  const known = blockly as unknown as Record<string, string>;
  for (const messages of LANGUAGES.map((tag) => textsOf(tag).blockly)) {
    for (const key of Object.keys(ptBR)) {
      expect(known, key).toHaveProperty(key);
      expect(messages[key]?.match(/%\d/g) ?? [], key).toEqual(known[key]?.match(/%\d/g) ?? []);
    }
  }
});
