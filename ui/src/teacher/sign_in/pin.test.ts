import { expect, test } from "vitest";
import { pinFault } from "./pin";

const texts = { pinFormat: "4 to 12 digits", different: "not the same" };

test("a PIN has 4 to 12 digits, which is said before that the two differ", () => {
  for (const pin of ["", "12", "1234567890123", "12a4", "12 4"]) {
    expect(pinFault(pin, "", texts)).toBe(texts.pinFormat);
  }
  expect(pinFault("1234", "1243", texts)).toBe(texts.different);
  expect(pinFault("1234", "1234", texts)).toBeNull();
  expect(pinFault("123456789012", "123456789012", texts)).toBeNull();
});
