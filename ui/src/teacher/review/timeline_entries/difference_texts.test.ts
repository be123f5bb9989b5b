import { expect, test } from "vitest";
import type { VersionDifference } from "../../../api/model";
import { textsOf } from "../../../i18n";
import { blockName, countTexts, differenceTexts, MAX_LISTED } from "./difference_texts";

const NONE: VersionDifference = { added: [], removed: [], changed: [], moved: [] };
const pt = textsOf("pt-BR").review;

test("a block is called by the words on it", () => {
  expect(blockName("turn", "pt-BR")).toBe("girar");
  expect(blockName("move_forward", "en")).toBe("move forward");
  expect(blockName("repeat", "pt-BR")).toBe("repetir…vezes");
  expect(blockName("of_a_later_release", "pt-BR")).toBe("of_a_later_release");
});

test("every block has a name", () => {
  expect(blockName("arc", "es")).toMatch(/\p{L}/u);
});

test("another value is told with the one before", () => {
  const changed = [
    {
      block: "a",
      type: "turn",
      what: [
        { name: "ANGLE", before: 90, after: 120.5 },
        { name: "DIRECTION", before: "LEFT", after: "RIGHT" },
      ],
    },
  ];
  expect(differenceTexts({ ...NONE, changed }, pt, "pt-BR")).toEqual([
    "em “girar” trocaram 90 por 120,5",
    "em “girar” trocaram à esquerda por à direita",
  ]);
});

test("blocks that came, went and moved are told by name, and equal ones are counted", () => {
  const found = differenceTexts(
    {
      changed: [],
      added: [
        { block: "a", type: "turn" },
        { block: "b", type: "turn" },
      ],
      removed: [{ block: "c", type: "stop" }],
      moved: [{ block: "d", type: "move_forward" }],
    },
    pt,
    "pt-BR",
  );
  expect(found).toEqual([
    "puseram “girar” (2×)",
    "tiraram “parar”",
    "mudaram “andar para frente” de lugar",
  ]);
});

test("a block of another kind in the place of one is told as that", () => {
  const what = [
    { name: "type", before: "turn", after: "stop" },
    { name: "ANGLE", before: 90, after: null },
  ];
  const changed = [{ block: "a", type: "stop", what }];
  expect(differenceTexts({ ...NONE, changed }, pt, "pt-BR")).toEqual([
    "trocaram “girar” por “parar”",
  ]);
});

test("not everything is told", () => {
  const added = ["turn", "stop", "wait", "arc", "move_forward", "move_backward"].map((type) => ({
    block: type,
    type,
  }));
  const found = differenceTexts({ ...NONE, added }, pt, "pt-BR");
  expect(found).toHaveLength(MAX_LISTED + 1);
  expect(found.at(-1)).toBe("e mais 2 coisas");
});

test("counts leave out what there is none of", () => {
  const texts = countTexts({ added: 2, removed: 0, changed: 1, moved: 0 }, pt);
  expect(texts).toEqual(["2 blocos a mais", "1 bloco com outro valor"]);
  expect(countTexts({ added: 0, removed: 0, changed: 0, moved: 0 }, pt)).toEqual([pt.line.same]);
});
