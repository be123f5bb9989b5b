import { expect, test } from "vitest";
import { numberIn } from "./NumberField";

test("numbers are read with comma or point, to the millimetre", () => {
  expect(numberIn("1,25")).toBe(1.25);
  expect(numberIn(" -0.5 ")).toBe(-0.5);
  expect(numberIn("\u22122")).toBe(-2);
  expect(numberIn("3,")).toBe(3);
  expect(numberIn("1,23456")).toBe(1.235);
});

test("what is no number is none", () => {
  for (const text of ["", "-", "a", "1,2,3", "1e9", "Infinity", "0x10"]) {
    expect(numberIn(text), text).toBeNull();
  }
});
