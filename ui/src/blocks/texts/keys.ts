import type { BlockType } from "../definitions";
import type { Category } from "../hues";

/** Words that belong to no single block. */
type Word =
  | "LEFT"
  | "RIGHT"
  | "FRONT"
  | "BACK"
  | "STRAIGHT"
  | "AROUND"
  | "ELSE"
  | "ELSE_IF"
  | "THEN"
  | "AND"
  | "OR"
  | "TRUE"
  | "FALSE"
  | `MATH_${"ROUND" | "ABS" | "SQRT" | "SIN" | "COS" | "TAN" | "MIN" | "MAX"}`
  | `COLOUR_${"BLUE" | "RED" | "GREEN" | "YELLOW" | "ORANGE" | "PURPLE" | "BLACK" | "WHITE" | "SAME"}`
  | "HELLO"
  | "QUESTION"
  | "WORD"
  | "VARIABLE_NAME"
  | "LIST_NAME"
  | "FUNCTION_NAME"
  | "PARAMETER_NAME"
  | "WITH"
  | "NEW_NAME"
  | "RENAME"
  | "ASK_NEW_NAME"
  | "ASK_RENAME"
  | "NAME_REFUSED"
  | "NAME_TAKEN"
  | "PLUS"
  | "PLUS_BRANCH"
  | "PLUS_PARAMETER"
  | "MINUS"
  | "MINUS_BRANCH"
  | "MINUS_PARAMETER"
  | "SEARCH"
  | "SEARCH_HINT"
  | "SEARCH_NOTHING"
  | "SEARCH_FOUND"
  | "HINT_EMPTY"
  | "OVERVIEW"
  | "BREAKPOINT_ADD"
  | "BREAKPOINT_REMOVE"
  | "OUT_OF_RANGE"
  | "AT_LEAST"
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
