import { expect, test } from "vitest";
import { fixLanguage } from "./known_language";

test("a language that no formatter takes is mended, any other left alone", () => {
  const nameless = { language: "C" } as Navigator;
  fixLanguage(nameless);
  expect(() => new Intl.NumberFormat(nameless.language)).not.toThrow();
  const english = { language: "en-GB" } as Navigator;
  fixLanguage(english);
  expect(english.language).toBe("en-GB");
});
