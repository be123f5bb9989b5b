import { expect, test } from "vitest";
import { manualOf } from "../../manual_pages";
import { searchManuals } from "./search";

const MANUALS = [
  manualOf(
    "teacher",
    "# Para professoras\n\n## Esqueci o PIN\n\nUm. Digite `pinel pin` no terminal. Fim.\n",
  ),
  manualOf(
    "install",
    "# Instalar\n\nSem internet.\n\n## Conferir\n\n| o que | onde |\n|---|---|\n| PIN | Terminal, aberto |\n",
  ),
];

const found = (query: string) =>
  searchManuals(MANUALS, query).map(({ manual, section, excerpt }) => [
    manual.name,
    section.id,
    excerpt,
  ]);

test("finds sections by the words of their text, and shows it from the sentence with them on", () => {
  expect(found("digite terminal")).toEqual([
    ["teacher", "esqueci-o-pin", "Digite pinel pin no terminal. Fim."],
  ]);
});

test("words of the heading come first; accents and capitals do not matter", () => {
  expect(found("CONFERÍR")).toEqual([["install", "conferir", "o que · onde"]]);
  expect(found("pin").map(([name]) => name)).toEqual(["teacher", "install"]);
});

test("the title of a manual finds its sections, and the text before the first heading", () => {
  expect(found("instalar")).toEqual([
    ["install", "", "Sem internet."],
    ["install", "conferir", "o que · onde"],
  ]);
});

test("cells of a table are set apart", () => {
  expect(found("pin aberto")).toEqual([["install", "conferir", "PIN · Terminal, aberto"]]);
});

test("finds nothing where a word is missing, and without a word", () => {
  expect(found("terminal fechado")).toEqual([]);
  expect(found("  ")).toEqual([]);
});
