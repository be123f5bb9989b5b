import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { describe, expect, test } from "vitest";

const FIRST = "src/styles.ts";
const LAZY = "src/styles_lazy.ts";
/** The editor also runs outside the page, so it imports its own style sheet. */
const STANDALONE = ["src/editor/index.ts", "src/editor/reader/viewer.ts"];

const files = readdirSync("src", { recursive: true, encoding: "utf8" }).map((path) =>
  join("src", path),
);
const read = (path: string) => readFileSync(path, "utf8");

function imported(path: string, pattern: RegExp): string[] {
  return [...read(path).matchAll(pattern)].map(([, name]) => join(dirname(path), name ?? ""));
}

/** Each sheet of a list, with the sheets that it imports. */
const sheets = (list: string) =>
  imported(list, /^import "(.+\.css)";/gm).map((path) => [
    path,
    ...imported(path, /^@import "(\.\/.+)";/gm),
  ]);
const wholes = [...sheets(FIRST), ...sheets(LAZY)];

/** Classes that a sheet styles everywhere on the screen, whatever surrounds them. */
function globalClasses(path: string): string[] {
  const text = read(path).replace(/\/\*[\s\S]*?\*\//g, "");
  const onScreen = text.replace(/@media print \{[\s\S]*?\n\}/g, "");
  const selectors = [...onScreen.matchAll(/([^{};]+)\{/g)].flatMap(([, all]) =>
    (all ?? "").split(/,(?![^(]*\))/),
  );
  return selectors.flatMap(
    (one) => /^\.([\w-]+)(::?[\w-]+(\([^)]*\))?|\[[^\]]*\])*$/.exec(one.trim())?.[1] ?? [],
  );
}

/** All modules that load with the page, without the lazy ones. */
function reached(from: string, found = new Set<string>()): Set<string> {
  if (found.has(from)) return found;
  found.add(from);
  for (const path of imported(from, /^(?:import|export) (?!type )[^;]*?"(\..+?)";/gm)) {
    const file = [".ts", ".tsx", "/index.ts"]
      .map((end) => path + end)
      .find((one) => files.includes(one));
    if (file) reached(file, found);
  }
  return found;
}

const classesIn = (path: string) =>
  [...read(path).matchAll(/\bclass(?:Name)?=(?:\{`([^`]*)`\}|"([^"]*)")/g)].flatMap(
    ([, made, plain]) => (made ?? plain ?? "").split(/[^\w-]+/),
  );

describe("style sheets", () => {
  test("what the start shows needs none that is fetched later", () => {
    const owners = new Map(
      sheets(LAZY).flatMap((whole) => whole.flatMap(globalClasses).map((name) => [name, whole[0]])),
    );
    const start = [...reached("src/main.tsx")];
    expect(start).toContain(join("src", "studio", "blocks_pane", "BlocksPane.tsx"));
    expect(start).not.toContain(join("src", "work", "WorkScreen.tsx"));
    const missing = start.flatMap((path) =>
      classesIn(path)
        .filter((name) => owners.has(name))
        .map((name) => [path, name, owners.get(name)]),
    );
    expect(missing).toEqual([]);
  });

  test("all stand in one of the two lists, whose order is the page's", () => {
    const all = files.filter((path) => path.endsWith(".css"));
    expect(wholes.flat().sort()).toEqual(all.sort());
  });

  test("no `:has()` watches the whole page, for which every edit of blocks would style all of it anew", () => {
    const around = /(^|[\s>+~,}])(?:\*|html|body|:root|\.screen|\.studio|\.page|\.blocks)?:has\(/m;
    expect(around.test("a > :has(b) {")).toBe(true);
    expect(wholes.flat().filter((path) => around.test(read(path)))).toEqual([]);
  });

  test("no part brings its own along", () => {
    const modules = files.filter(
      (path) => /\.tsx?$/.test(path) && ![FIRST, LAZY, ...STANDALONE].includes(path),
    );
    expect(modules.filter((path) => /^import .*\.css"/m.test(read(path)))).toEqual([]);
  });

  test("only the kit's sheet says whose arrow a select has", () => {
    const setsAppearance = /[^{};]*\bselect\b[^{};]*\{[^}]*\bappearance\b/;
    const sheets = wholes.flat().filter((path) => setsAppearance.test(read(path)));
    expect(sheets).toEqual([join("src", "kit", "controls.css")]);
  });

  test("a class belongs to one sheet", () => {
    const owners = new Map<string, Set<string>>();
    for (const whole of wholes) {
      for (const name of whole.flatMap(globalClasses)) {
        owners.set(name, (owners.get(name) ?? new Set()).add(whole[0] ?? ""));
      }
    }
    const shared = [...owners]
      .filter(([, sheets]) => sheets.size > 1)
      .map(([name, sheets]) => [name, ...sheets]);
    expect(shared).toEqual([]);
  });
});
