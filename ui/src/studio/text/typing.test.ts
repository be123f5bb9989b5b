import { describe, expect, test } from "vitest";
import { type Change, indent, newLine, offsetOf, outdent } from "./typing";

/** A text with its selection between bars; one bar is a caret. */
function typed(marked: string, act: (text: string, at: { start: number; end: number }) => Change) {
  const [before = "", inside = "", after] = marked.split("|");
  const text = before + inside + (after ?? "");
  const end = after === undefined ? before.length : before.length + inside.length;
  const change = act(text, { start: before.length, end });
  const next = text.slice(0, change.from) + change.text + text.slice(change.to);
  const { start, end: stop } = change.after;
  const bar = start === stop ? "" : "|";
  return `${next.slice(0, start)}|${next.slice(start, stop)}${bar}${next.slice(stop)}`;
}

describe("Enter", () => {
  test.each([
    ["robot.stop()|", "robot.stop()\n|"],
    ["    robot.stop()|", "    robot.stop()\n    |"],
    ["while True:|", "while True:\n    |"],
    ["    if a == 1:  # one|", "    if a == 1:  # one\n        |"],
    ["a|b", "a\n|b"],
  ])("%j becomes %j", (before, after) => expect(typed(before, newLine)).toBe(after));
});

describe("Tab", () => {
  test.each([
    ["|", "    |"],
    ["ab|c", "ab  |c"],
    ["|a\nb|", "|    a\n    b|"],
    ["|a\n|b", "|    a\n|b"],
  ])("%j becomes %j", (before, after) => expect(typed(before, indent)).toBe(after));
});

describe("Shift and Tab", () => {
  test.each([
    ["    a|", "a|"],
    ["  a|b", "a|b"],
    ["|a", "|a"],
    ["|    a\n  b|", "|a\nb|"],
  ])("%j becomes %j", (before, after) => expect(typed(before, outdent)).toBe(after));
});

test("a line and a column are a place in the text, and never outside", () => {
  const text = "ab\ncde\n";
  expect(offsetOf(text, 1, 1)).toBe(0);
  expect(offsetOf(text, 2, 3)).toBe(5);
  expect(offsetOf(text, 2, 99)).toBe(6);
  expect(offsetOf(text, 99, 1)).toBe(text.length);
});
