import { describe, expect, test } from "vitest";
import { expectedSigns, hasCapture } from "./expected";

const RESULT = { gesture: "result" };
const capture = { action: "classify_gestures", timeout: 10 };
const is = (left: unknown, right: unknown, op = "==") => ({ op, args: [left, right] });
const when = (condition: object, ...commands: object[]) => ({
  action: "conditional_execution",
  condition,
  commands,
});
const program = (...commands: object[]) => ({ pinel_ir: 1, functions: [], commands });

const NUMBER = { gesture: "number" };

test("a program that waits for a number needs the camera, and expects no sign of it", () => {
  const document = program({ action: "read_number" }, when(is(NUMBER, 3)), when(is(NUMBER, "B")));
  expect(hasCapture(document)).toBe(true);
  expect(expectedSigns(document)).toEqual([]);
});

describe("the signs that a program expects", () => {
  test("are those that it compares the answer of a capture with, each once, in their order", () => {
    const document = program(
      capture,
      when(is(RESULT, "B"), when(is("A", RESULT))),
      when({ op: "or", args: [is(RESULT, "b"), is(RESULT, "C", "!=")] }),
    );
    expect(expectedSigns(document)).toEqual(["B", "A", "C"]);
  });

  test("are also those that a variable is compared with which keeps the answer", () => {
    const document = program(
      capture,
      { action: "set_variable", name: "letra", value: RESULT },
      when(is({ var: "letra" }, "L")),
      when(is({ var: "cor" }, "R")),
    );
    expect(expectedSigns(document)).toEqual(["L"]);
  });

  test("are words too, as they are written; capitals do not matter", () => {
    const document = program(
      capture,
      when(is(RESULT, "vai"), when(is(RESULT, "Vai"))),
      when(is(RESULT, "b")),
      when(is(RESULT, "x".repeat(101))),
    );
    expect(expectedSigns(document)).toEqual(["vai", "B"]);
  });

  test("are found in functions, and no empty answer is among them", () => {
    const ask = { name: "perguntar", commands: [capture, when(is(RESULT, "V"))] };
    const document = { ...program(when(is(RESULT, ""))), functions: [ask] };
    expect(expectedSigns(document)).toEqual(["V"]);
  });

  test("are none without a program, or where other texts are compared", () => {
    expect(expectedSigns(null)).toEqual([]);
    expect(expectedSigns(program(when(is({ sensor: "color" }, "red"))))).toEqual([]);
  });
});

test("a program captures where a command does, however deep", () => {
  expect(hasCapture(null)).toBe(false);
  expect(hasCapture(program(when(is(RESULT, "B"))))).toBe(false);
  expect(hasCapture(program({ action: "repeat", times: 2, commands: [capture] }))).toBe(true);
});
