import { expect, test } from "vitest";
import { pinFault } from "./pin";

const words = { pinFormat: "4 to 12 digits", different: "not the same" };

test("a PIN has 4 to 12 digits, which is said before that the two differ", () => {
  for (const pin of ["", "12", "1234567890123", "12a4", "12 4"]) {
    expect(pinFault(pin, "", words)).toBe(words.pinFormat);
  }
  expect(pinFault("1234", "1243", words)).toBe(words.different);
  expect(pinFault("1234", "1234", words)).toBeNull();
  expect(pinFault("123456789012", "123456789012", words)).toBeNull();
});
