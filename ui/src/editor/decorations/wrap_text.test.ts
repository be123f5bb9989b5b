import { expect, test } from "vitest";
import { wrapText } from "./wrap_text";

test("breaks between words, and leaves a word that is too long whole", () => {
  expect(wrapText("um dois três quatrocentos", 8)).toBe("um dois\ntrês\nquatrocentos");
});
