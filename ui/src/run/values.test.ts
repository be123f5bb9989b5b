import { expect, test } from "vitest";
import { textsOf } from "../i18n";
import { valueWords } from "./values";

const ptBR = textsOf("pt-BR");

test.each([
  [3, "3"],
  [-0.5, "−0,5"],
  [1 / 3, "0,3333"],
  [12345, "12345"],
  [true, "verdadeiro"],
  ["3", "“3”"],
  ["", "(vazio)"],
  [[1.5, "a", false], "[1,5; “a”; falso]"],
])("%j is shown as %s", (value, words) => {
  expect(valueWords(value, ptBR, "pt-BR")).toBe(words);
});

test("numbers and lists are written as in the language", () => {
  expect(valueWords([1.5, 2], textsOf("en"), "en")).toBe("[1.5, 2]");
});
