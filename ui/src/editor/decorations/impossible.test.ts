import * as Blockly from "blockly/core";
import { afterEach, beforeAll, describe, expect, test } from "vitest";
import { registerBlocks } from "../../blocks";
import { setKnownPlaces } from "../../blocks/known_places";
import { workspaceOf } from "../../blocks/loader";
import { setBlockLanguage } from "../../blocks/texts";
import { impossibleIn } from "./impossible";

beforeAll(() => {
  setBlockLanguage("pt-BR");
  registerBlocks();
});
afterEach(() => setKnownPlaces(null));

const FLOOR = { sensor: "floor" };
const CELL = { sensor: "cell" };
const is = (left: unknown, right: unknown, op = "==") => ({ op, args: [left, right] });
const until = (block: string, condition: object) => ({
  ...{ action: "until", block, condition, commands: [] },
});

function textsFor(...commands: object[]): Record<string, string[]> {
  const workspace = new Blockly.Workspace();
  const document = { pinel_ir: 1, name: "p", functions: [], commands };
  Blockly.serialization.workspaces.load(workspaceOf(document), workspace);
  return Object.fromEntries([...impossibleIn(workspace)].map(([id, texts]) => [id, [...texts]]));
}

describe("a colour of the floor", () => {
  test("in words is none: the notice names the block that is meant", () => {
    expect(textsFor(until("a", is(FLOOR, "Vermelho")))).toEqual({
      a: [
        "A cor do chão nunca é igual ao texto “Vermelho”.",
        "Troquem o texto pelo bloco de cor “vermelho”, que está em Sensores.",
      ],
    });
  });

  test("that does not exist is told with those that do", () => {
    const { a } = textsFor(until("a", { op: "not", args: [is("rosa", FLOOR, "!=")] }));
    expect(a?.[1]).toMatch(/: .*vermelho.*branco/);
  });

  test("as the colour block or as the document writes it is no notice", () => {
    expect(textsFor(until("a", is(FLOOR, "red")))).toEqual({});
    expect(textsFor(until("a", is({ var: "cor" }, "vermelho")))).toEqual({});
  });
});

describe("a place", () => {
  test("that the world does not have is told with those that it has", () => {
    setKnownPlaces(["A", "B"]);
    expect(textsFor(until("a", is(CELL, "a")), until("b", is(CELL, "B")))).toEqual({
      a: [
        "Este mundo não tem um lugar com o nome “a”.",
        "Os lugares dele são: A, B. Maiúsculas e minúsculas fazem diferença.",
      ],
    });
  });

  test("is told of in a world without places, and outside of places the name is empty", () => {
    setKnownPlaces([]);
    expect(textsFor(until("a", is(CELL, "A"))).a?.[1]).toMatch("não tem lugares");
    expect(textsFor(until("a", is(CELL, "")))).toEqual({});
  });

  test("is not told of while the world is not known", () => {
    expect(textsFor(until("a", is(CELL, "Z")))).toEqual({});
  });
});

describe("a place to drive to", () => {
  const go = (block: string, place: unknown) => ({ action: "go_to_place", block, place });

  test("that the world does not have is told with those that it has, in any case", () => {
    setKnownPlaces(["A", "B"]);
    expect(textsFor(go("a", "H"), go("b", "b"), go("c", { var: "letra" }), go("d", ""))).toEqual({
      a: ["Este mundo não tem um lugar com o nome “H”.", "Os lugares dele são: A, B."],
    });
  });

  test("is told of in a world without places, and not while the world is not known", () => {
    setKnownPlaces([]);
    expect(textsFor(go("a", "A")).a?.[1]).toMatch("não tem lugares");
    setKnownPlaces(null);
    expect(textsFor(go("a", "A"))).toEqual({});
  });
});
