import { describe, expect, test } from "vitest";
import { ConditionError, parseCondition } from "./conditions";

const result = { gesture: "result" };
const is = (letter: string) => ({ op: "==", args: [result, letter] });

describe("a condition of the original", () => {
  test.each([
    ['result == "B"', is("B")],
    ["resultado=='B'", is("B")],
    ['result == "B" or result == "A"', { op: "or", args: [is("B"), is("A")] }],
    [
      '(result == "B" || result == "A") && !(1 <= 2.5)',
      {
        op: "and",
        args: [
          { op: "or", args: [is("B"), is("A")] },
          { op: "not", args: [{ op: "<=", args: [1, 2.5] }] },
        ],
      },
    ],
    ["not not result", { op: "not", args: [{ op: "not", args: [result] }] }],
    ["-1 < .5", { op: "<", args: [-1, 0.5] }],
    ['result != "B" ', { op: "!=", args: [result, "B"] }],
    [
      '"a" == "b" and 1 == 1 and 2 == 2',
      {
        op: "and",
        args: [
          { op: "==", args: ["a", "b"] },
          { op: "==", args: [1, 1] },
          { op: "==", args: [2, 2] },
        ],
      },
    ],
  ])("%s is a tree", (text, tree) => {
    expect(parseCondition(text)).toEqual(tree);
  });

  test.each([
    "",
    "result ==",
    "x == 1",
    "result = 'B'",
    "__import__('os')",
    "1 2",
    "(result",
    "é",
  ])("%j is none", (text) => {
    expect(() => parseCondition(text)).toThrow(ConditionError);
  });

  test("does not nest without end", () => {
    expect(() => parseCondition(`${"(".repeat(70)}1${")".repeat(70)}`)).toThrow(ConditionError);
  });
});
