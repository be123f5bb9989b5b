import * as blockly from "blockly/msg/en";
import { expect, test } from "vitest";
import editorFile from "../../../pinel_desktop/messages/catalogue/pt-BR/page/editor.json";
import { textsOf } from ".";
import { LANGUAGES } from "./languages";

test("every message of our own is one that Blockly knows, with the same places", () => {
  const known = blockly as unknown as Record<string, string>;
  for (const messages of LANGUAGES.map((tag) => textsOf(tag).blockly)) {
    for (const key of Object.keys(editorFile.editor)) {
      expect(known, key).toHaveProperty(key);
      expect(messages[key]?.match(/%\d/g) ?? [], key).toEqual(known[key]?.match(/%\d/g) ?? []);
    }
  }
});
