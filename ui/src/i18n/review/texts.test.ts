import { describe, expect, test } from "vitest";
import { LANGUAGES } from "../language";
import { figureWords, REVIEW_TEXTS } from ".";

type Leaf = string | ((...args: never[]) => string);

function leaves(node: object, path = ""): [string, string][] {
  return Object.entries(node).flatMap(([key, value]: [string, Leaf | object]) => {
    const here = `${path}/${key}`;
    if (typeof value === "string") return [[here, value]] as [string, string][];
    if (typeof value === "object") return leaves(value, here);
    return [1, 2].map((n) => {
      const text = (value as (...args: unknown[]) => string)(n, n, n);
      return [`${here}(${n})`, String(text)] as [string, string];
    });
  });
}

describe.each(LANGUAGES)("the words of the review in %s", (language) => {
  const texts = leaves(REVIEW_TEXTS[language]);

  test("are there for every key, and none is empty", () => {
    expect(texts.map(([path]) => path)).toEqual(
      leaves(REVIEW_TEXTS["pt-BR"]).map(([path]) => path),
    );
    for (const [path, text] of texts) {
      expect(text.trim(), path).not.toBe("");
      expect(text, path).not.toMatch(/undefined|NaN|\[object|TODO/);
    }
  });

  test("are another language's nowhere", () => {
    const others = LANGUAGES.filter((other) => other !== language).flatMap((other) =>
      leaves(REVIEW_TEXTS[other]).map(([path, text]) => `${path} ${text}`),
    );
    for (const [path, text] of texts) {
      if (text.length > 24) expect(others).not.toContain(`${path} ${text}`);
    }
  });
});

test("the server says what each figure counts", () => {
  const names = Object.keys(REVIEW_TEXTS["pt-BR"].figures).filter((name) => /_/.test(name));
  for (const name of names) expect(figureWords(name).remedy, name).not.toBe("");
});
