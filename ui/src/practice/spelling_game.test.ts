import { describe, expect, test } from "vitest";
import { LETTERS } from "../api/declared";
import { drawTargets, N_TARGETS, SpellingGame } from "./spelling_game";

const catalogue = import.meta.glob<{ game: { words: string } }>(
  "../../../pinel_desktop/messages/catalogue/*/page/game.json",
  { eager: true, import: "default" },
);

describe("a round of words", () => {
  const spell = (game: SpellingGame, letters: string) => {
    for (const letter of letters) game.receive(letter);
  };

  test("is spelled letter by letter; another sign is told and costs nothing", () => {
    const game = new SpellingGame(["SOL", "UVA"]);
    spell(game, "SB");
    expect([game.next.value, game.other.value, game.nSpelled.value]).toEqual(["O", "B", 1]);
    spell(game, "OL");
    expect([game.current.value, game.nSpelled.value]).toEqual(["UVA", 0]);
    spell(game, "UVA");
    expect(game.current.value).toBeNull();
    expect(game.outcome.spelled).toEqual(["SOL", "UVA"]);
  });

  test("says at its end which letters needed no hint, and which to make again", () => {
    const game = new SpellingGame(["SOL", "MAR", "LUA"]);
    game.receive("S");
    game.hint();
    spell(game, "OL");
    game.skip();
    spell(game, "LUA");
    expect(game.outcome).toEqual({
      spelled: ["SOL", "LUA"],
      alone: ["A", "L", "S", "U"],
      hinted: ["O"],
    });
    game.receive("A");
    expect(game.current.value).toBeNull();
  });

  test("has different words of the list", () => {
    const drawn = drawTargets(["A", "B", "C", "D", "E", "F"], () => 0.99);
    expect(drawn).toEqual(["F", "E", "D", "C", "B"]);
    expect(drawn).toHaveLength(N_TARGETS);
  });

  test.each(Object.entries(catalogue))("%s has letters at rest only, none twice in a row", (_, {
    game,
  }) => {
    const targets = game.words.split(" ");
    expect(targets.length).toBeGreaterThanOrEqual(20);
    expect(new Set(targets).size).toBe(targets.length);
    for (const target of targets) {
      expect(
        [...target].filter((letter) => !LETTERS.includes(letter as never)),
        target,
      ).toEqual([]);
      expect(target).not.toMatch(/(.)\1/);
    }
  });
});
