import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "vitest";
import { textsOf } from ".";

/** Words of the sources in which a key may stand: all but the texts themselves and the tests. */
const said = new Set(
  readdirSync("src", { recursive: true, encoding: "utf8" })
    .filter(
      (path) => /\.tsx?$/.test(path) && !/\.test\.|^i18n.(?!format|phrases)|^api.types/.test(path),
    )
    .flatMap((path) => readFileSync(join("src", path), "utf8").match(/\w+/g) ?? []),
);

/** The paths of all texts: "header/theme/light". */
function keys(node: object, path: readonly string[] = []): string[] {
  return Object.entries(node).flatMap(([key, value]) => {
    const here = [...path, key];
    return typeof value === "object" ? keys(value, here) : [here.join("/")];
  });
}

/** The words of the sources that a key of the blocks is made from: "COLOUR_BLUE" of blue, "MOVE_TIP" of move. */
function parts(key: string): string[] {
  const whole = key.replace(/_TIP$/, "");
  return [key, whole.toLowerCase(), whole.replace(/^[A-Z]+_/, "").toLowerCase()];
}

const { blocks, blockly, searchTerms, reasons, figures, cameraProblems, ...page } =
  textsOf("pt-BR");

test("every text of the page is used somewhere", () => {
  const names = (path: string) => {
    const name = path.split("/").at(-1) ?? "";
    return [name, name.replace(/Help$/, "")]; // debug[`${name}Help`]
  };
  const unused = keys(page).filter((path) => !names(path).some((name) => said.has(name)));
  expect(unused).toEqual([]);
});

test("every word that the search knows belongs to a block", () => {
  expect(Object.keys(searchTerms).filter((type) => !(type.toUpperCase() in blocks))).toEqual([]);
});

test("every text of the blocks belongs to something in the sources", () => {
  const unused = Object.keys(blocks).filter((key) => !parts(key).some((part) => said.has(part)));
  expect(unused).toEqual([]);
});
