import { expect, test } from "vitest";
import { daysText, shortDay } from "./days";

const day = (number: number, year = 2026) => new Date(year, 10, number);

test("one day is said with its day of the week", () => {
  expect(daysText([day(19)], "pt-BR")).toBe("Quinta-feira, 19 de novembro de 2026");
});

test("several days are all said, their year once", () => {
  const days = [day(19), day(20), day(21)];
  expect(daysText(days, "pt-BR")).toBe("19 de novembro, 20 de novembro e 21 de novembro de 2026");
  expect(daysText([day(19, 2025), day(21)], "es")).toBe(
    "19 de noviembre de 2025 y 21 de noviembre de 2026",
  );
});

test("a day under the line does not break", () => {
  expect(shortDay(day(19).getTime() / 1000, "pt-BR")).toBe("19\u00a0de\u00a0nov.");
});
