import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { describe, expect, test } from "vitest";

const SHEETS = "src/styles.ts";
/** The editor is also shown apart from the page, and brings its own sheet there. */
const APART = ["src/editor/index.ts", "src/editor/reader.ts"];

const files = readdirSync("src", { recursive: true, encoding: "utf8" }).map((path) =>
  join("src", path),
);
const read = (path: string) => readFileSync(path, "utf8");

function imported(path: string, word: RegExp): string[] {
  return [...read(path).matchAll(word)].map(([, name]) => join(dirname(path), name ?? ""));
}

const listed = imported(SHEETS, /^import "(.+\.css)";/gm);
/** A sheet with those it is made of. */
const wholes = listed.map((path) => [path, ...imported(path, /^@import "(\.\/.+)";/gm)]);

/** Classes that a sheet styles wherever they stand, on any screen and not only on paper. */
function owned(path: string): string[] {
  const text = read(path).replace(/\/\*[\s\S]*?\*\//g, "");
  const onScreen = text.replace(/@media print \{[\s\S]*?\n\}/g, "");
  const selectors = [...onScreen.matchAll(/([^{};]+)\{/g)].flatMap(([, all]) =>
    (all ?? "").split(/,(?![^(]*\))/),
  );
  return selectors.flatMap(
    (one) => /^\.([\w-]+)(::?[\w-]+(\([^)]*\))?|\[[^\]]*\])*$/.exec(one.trim())?.[1] ?? [],
  );
}

describe("style sheets", () => {
  test("all stand in the one list, whose order is the page's", () => {
    const all = files.filter((path) => path.endsWith(".css"));
    expect(wholes.flat().sort()).toEqual(all.sort());
  });

  test("no part brings its own along", () => {
    const modules = files.filter(
      (path) => /\.tsx?$/.test(path) && ![SHEETS, ...APART].includes(path),
    );
    expect(modules.filter((path) => /^import .*\.css"/m.test(read(path)))).toEqual([]);
  });

  test("a class belongs to one sheet", () => {
    const owners = new Map<string, Set<string>>();
    for (const whole of wholes) {
      for (const name of whole.flatMap(owned)) {
        owners.set(name, (owners.get(name) ?? new Set()).add(whole[0] ?? ""));
      }
    }
    const shared = [...owners]
      .filter(([, sheets]) => sheets.size > 1)
      .map(([name, sheets]) => [name, ...sheets]);
    expect(shared).toEqual([]);
  });
});
