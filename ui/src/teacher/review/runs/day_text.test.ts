import { expect, test } from "vitest";
import { dayText, readDay } from "./day_text";

test("a day is written as the language writes it", () => {
  expect(dayText("2026-11-08", "pt-BR")).toBe("08/11/2026");
  expect(dayText("2026-11-08", "en")).toBe("11/08/2026");
  expect(dayText("", "fr")).toBe("");
});

test.each(["18/11/2026", "18.11.26", "18-11-2026", " 18 / 11 "])("%s is read as a day", (text) => {
  expect(readDay(text, "pt-BR", new Date(2026, 2, 1))).toBe("2026-11-18");
});

test("English has the month first", () => {
  expect(readDay("11/18/2026", "en")).toBe("2026-11-18");
});

test.each(["31/02/2026", "18", "ontem", "", "0/0/0", "18/11/20266"])("%s is no day", (text) => {
  expect(readDay(text, "pt-BR")).toBeNull();
});
