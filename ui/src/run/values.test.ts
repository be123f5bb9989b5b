import { expect, test } from "vitest";
import { textsOf } from "../i18n";
import { localizeNumbers, valueText } from "./values";

const ptBR = textsOf("pt-BR");

test.each([
  [3, "3"],
  [-0.5, "−0,5"],
  [1 / 3, "0,33"],
  [3.82905218142, "3,83"],
  [0.012345678, "0,012"],
  [0.0625, "0,0625"],
  [12345, "12345"],
  [true, "verdadeiro"],
  ["3", "“3”"],
  ["", "(vazio)"],
  [[1.5, "a", false], "[1,5; “a”; falso]"],
])("%j is shown as %s", (value, expected) => {
  expect(valueText(value, ptBR, "pt-BR")).toBe(expected);
});

test("numbers and lists are written as in the language", () => {
  expect(valueText([1.5, 2], textsOf("en"), "en")).toBe("[1.5, 2]");
});

test.each([
  ["3.82905218142", "3,83"],
  ["-0.5", "−0,5"],
  ["4", "4"],
  ["parede a 0.7319 m.", "parede a 0,7319 m."],
  ["x=1.20000000001", "x=1,2"],
  ["1, 2.5, 3", "1; 2,5; 3"],
  ["Andei 1.000 m, ou 1.234 m", "Andei 1.000 m, ou 1.234 m"],
  ["versão 1.2.3 de 24.11.2026", "versão 1.2.3 de 24.11.2026"],
  ["0,5 e R2.5D2", "0,5 e R2.5D2"],
  ["Olá!", "Olá!"],
  ["", ""],
])("the robot's %j is read as %s in Portuguese", (text, expected) => {
  expect(localizeNumbers(text, "pt-BR")).toBe(expected);
});

test("English keeps the point and loses the digits", () => {
  expect(localizeNumbers("3.82905218142 m", "en")).toBe("3.83 m");
  expect(localizeNumbers("1, 2.5", "en")).toBe("1, 2.5");
});
