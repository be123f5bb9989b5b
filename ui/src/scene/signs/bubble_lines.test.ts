import { expect, test } from "vitest";
import { bubbleLines, characters, isRightToLeft } from "./bubble_lines";

test.each([
  ["Cheguei à padaria!", ["Cheguei à padaria!"]],
  ["0,25", ["0,25"]],
  ["", []],
  ["Agora vou virar à direita", ["Agora vou virar à", "direita"]],
  [
    "um dois três quatro cinco seis sete oito nove dez onze doze treze",
    ["um dois três quatro", "cinco seis sete oito…"],
  ],
  ["x".repeat(60), ["x".repeat(24), `${"x".repeat(23)}…`]],
])("%j", (text, lines) => {
  expect(bubbleLines(text)).toEqual(lines);
});

test("two lines have room for 24 characters each, also of emoji", () => {
  for (const text of [
    "🤖".repeat(60),
    "👩‍🔬".repeat(60),
    "a ".repeat(90),
    `${"ß".repeat(23)} `.repeat(9),
  ]) {
    const lines = bubbleLines(text);
    expect(lines).toHaveLength(2);
    for (const line of lines) expect(characters(line).length).toBeLessThanOrEqual(24);
    expect(lines[1]).toMatch(/…$/u);
  }
});

test("on a low floor a text has one line", () => {
  expect(bubbleLines("Agora vou virar à direita", 1)).toEqual(["Agora vou virar à…"]);
  expect(bubbleLines("Oi", 1)).toEqual(["Oi"]);
});

test("the direction is that of the first letter", () => {
  expect(isRightToLeft("12 سلام")).toBe(true);
  expect(isRightToLeft("olá سلام")).toBe(false);
  expect(isRightToLeft("123")).toBe(false);
});
