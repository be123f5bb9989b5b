import { expect, test } from "vitest";
import { textsOf } from "../../i18n";
import { blocksNotOffered } from "./level_notices";

const { blocks } = textsOf("pt-BR");
const labelOf = (type: string) => blocks[type.toUpperCase() as keyof typeof blocks] ?? "";

test.each([
  ["Usem “esperar 2 s” no meio.", 1, []],
  ["Repetir até que encoste.", 1, []], // not in quotation marks
  ["Usem “repetir até que” e meçam.", 1, ["repetir até que"]],
  ["Usem 'repetir até que' e meçam.", 3, []],
  ['Usem "um bloco que não existe".', 1, []],
] as const)("%s at level %d names %j", (hint, level, names) => {
  expect(blocksNotOffered(hint, level, labelOf)).toEqual(names);
});
