import type { BlockType } from "../definitions";
import type { Category } from "../hues";

/** Words that belong to no single block. */
type Word =
  | "LEFT"
  | "RIGHT"
  | "ELSE"
  | "AND"
  | "OR"
  | "HINT_EMPTY"
  | "OUT_OF_RANGE"
  | "NOT_A_NUMBER"
  | "ZOOM_IN"
  | "ZOOM_OUT"
  | "ZOOM_TO_FIT"
  | "DECIMAL_SEPARATOR";

type CategoryWord = `CATEGORY_${Uppercase<Exclude<Category, "start">>}`;
type BlockWord = Uppercase<BlockType> | `${Uppercase<BlockType>}_TIP`;

export type TextKey = Word | CategoryWord | BlockWord;

/**
 * One language. A block's text is what stands on it, with `%1`, `%2` for its icon and fields in their order; its
 * `_TIP` says when to use it. A missing key does not compile.
 */
export type BlockTexts = Readonly<Record<TextKey, string>>;
