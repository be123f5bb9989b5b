import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { compile, type Values } from "./compile";
import { LANGUAGES } from "./languages";

type Text = (values: Values) => string;
const compiled = (entry: Parameters<typeof compile>[0], language: "pt-BR" | "en" = "en") =>
  compile(entry, language) as Record<string, Text>;

test("a text without placeholders stays a string, also in lists", () => {
  expect(compile({ a: "Ready", b: ["x", "y"] }, "en")).toEqual({ a: "Ready", b: ["x", "y"] });
});

test("placeholders are filled by their names, literally, and once", () => {
  const { greet } = compiled({ greet: "{{name}}, {{name}} and {{other}}" });
  expect(greet?.({ name: "{{other}} $& %1", other: "B" })).toBe(
    "{{other}} $& %1, {{other}} $& %1 and B",
  );
});

test("a number that asks for it is written as the language writes it", () => {
  expect(compiled({ way: "{{m, number}} m" }, "pt-BR").way?.({ m: 0.1 + 0.2 })).toBe("0,3 m");
});

test("the forms of a plural are one function of the count", () => {
  const entry = { runs_zero: "none", runs_one: "{{count}} run", runs_other: "{{count}} runs" };
  const { runs } = compiled(entry);
  expect([0, 1, 2, 21].map((count) => runs?.({ count }))).toEqual([
    "none",
    "1 run",
    "2 runs",
    "21 runs",
  ]);
  expect(
    compiled({ n_one: "{{count}} vez", n_other: "{{count}} vezes" }, "pt-BR").n?.({ count: 0 }),
  ).toBe("0 vez");
});

test.each(LANGUAGES)("the server's plural rule of %s is the browser's", (language) => {
  const path = `../pinel_desktop/messages/catalogue/${language}/language.json`;
  const { plural } = JSON.parse(readFileSync(path, "utf8")) as { plural: Record<string, string> };
  const rules = Object.entries(plural).map(
    ([form, condition]) => [form, new Function("n", `return ${condition}`)] as const,
  );
  for (let n = 0; n <= 1000; n++) {
    const form = rules.find(([, holds]) => holds(n))?.[0] ?? "other";
    expect(form, String(n)).toBe(new Intl.PluralRules(language).select(n));
  }
});
