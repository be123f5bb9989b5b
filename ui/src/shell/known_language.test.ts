import { expect, test } from "vitest";
import { mendLanguage } from "./known_language";

test("a language that no formatter takes is mended, any other left alone", () => {
  const nameless = { language: "C" } as Navigator;
  mendLanguage(nameless);
  expect(() => new Intl.NumberFormat(nameless.language)).not.toThrow();
  const english = { language: "en-GB" } as Navigator;
  mendLanguage(english);
  expect(english.language).toBe("en-GB");
});
