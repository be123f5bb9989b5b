import type { BlockCards } from "../../editor/block_cards";
import type { Language } from "../../i18n";

/** Lists of printable cards: blocks of the lesson or of a level, or the signs of the lesson. */
export const CARD_LISTS = ["lesson", "level1", "level2", "level3", "letters"] as const;
export type CardList = (typeof CARD_LISTS)[number];

/** The letters of the lesson, as in its plan. */
export const LESSON_LETTERS = ["A", "B", "E", "L", "S", "T"] as const;

const LEVELS = { level1: 1, level2: 2, level3: 3 } as const;

/** The blocks of a list as cards. Fetches the editor, which draws them. */
export async function blockCards(
  list: Exclude<CardList, "letters">,
  language: Language,
): Promise<BlockCards> {
  const { drawCards, LESSON_BLOCKS } = await import("../../editor/block_cards");
  return drawCards(language, list === "lesson" ? LESSON_BLOCKS : LEVELS[list]);
}
