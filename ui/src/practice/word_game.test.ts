import { describe, expect, test } from "vitest";
import { LETTERS } from "../api/declared";
import { drawWords, N_WORDS, WordGame } from "./word_game";

const catalogue = import.meta.glob<{ game: { words: string } }>(
  "../../../pinel_desktop/messages/catalogue/*/page/game.json",
  { eager: true, import: "default" },
);

describe("a round of words", () => {
  const spell = (game: WordGame, letters: string) => {
    for (const letter of letters) game.receive(letter);
  };

  test("is spelled letter by letter; another sign is told and costs nothing", () => {
    const game = new WordGame(["SOL", "UVA"]);
    spell(game, "SB");
    expect([game.next.value, game.other.value, game.nSpelled.value]).toEqual(["O", "B", 1]);
    spell(game, "OL");
    expect([game.current.value, game.nSpelled.value]).toEqual(["UVA", 0]);
    spell(game, "UVA");
    expect(game.current.value).toBeNull();
    expect(game.outcome.words).toEqual(["SOL", "UVA"]);
  });

  test("says at its end which letters needed no hint, and which to make again", () => {
    const game = new WordGame(["SOL", "MAR", "LUA"]);
    game.receive("S");
    game.hint();
    spell(game, "OL");
    game.skip();
    spell(game, "LUA");
    expect(game.outcome).toEqual({
      words: ["SOL", "LUA"],
      alone: ["A", "L", "S", "U"],
      hinted: ["O"],
    });
    game.receive("A");
    expect(game.current.value).toBeNull();
  });

  test("has different words of the list", () => {
    const words = drawWords(["A", "B", "C", "D", "E", "F"], () => 0.99);
    expect(words).toEqual(["F", "E", "D", "C", "B"]);
    expect(words).toHaveLength(N_WORDS);
  });

  test.each(Object.entries(catalogue))("%s has letters at rest only, none twice in a row", (_, {
    game,
  }) => {
    const words = game.words.split(" ");
    expect(words.length).toBeGreaterThanOrEqual(20);
    expect(new Set(words).size).toBe(words.length);
    for (const word of words) {
      expect(
        [...word].filter((letter) => !LETTERS.includes(letter as never)),
        word,
      ).toEqual([]);
      expect(word).not.toMatch(/(.)\1/);
    }
  });
});
