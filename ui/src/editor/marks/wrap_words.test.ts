import { expect, test } from "vitest";
import { wrapWords } from "./wrap_words";

test("breaks between words, and leaves a word that is too long whole", () => {
  expect(wrapWords("um dois três quatrocentos", 8)).toBe("um dois\ntrês\nquatrocentos");
});
