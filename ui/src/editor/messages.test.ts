import * as en from "blockly/msg/en";
import { expect, test } from "vitest";
import { OWN_MESSAGES } from "./messages";

test("every message of our own is one that Blockly knows, with the same places", () => {
  const known = en as unknown as Record<string, string>;
  for (const messages of Object.values(OWN_MESSAGES)) {
    for (const [key, text] of Object.entries(messages)) {
      expect(known, key).toHaveProperty(key);
      expect(text.match(/%\d/g) ?? [], key).toEqual(known[key]?.match(/%\d/g) ?? []);
    }
  }
});

test("Portuguese and Spanish cover the same messages", () => {
  expect(Object.keys(OWN_MESSAGES.es).sort()).toEqual(Object.keys(OWN_MESSAGES["pt-BR"]).sort());
});
