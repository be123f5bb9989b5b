import * as Blockly from "blockly/core";
import { type Language, type Texts, textsOf } from "../i18n";

export type TextKey = keyof Texts["blocks"];

const PREFIX = "PINEL_";

let termsByType: Readonly<Record<string, string>> = {};

/** Gives Blockly the texts of a language; blocks created afterwards use it. */
export function setBlockLanguage(language: Language): void {
  const { blocks, searchTerms: terms } = textsOf(language);
  for (const [key, text] of Object.entries(blocks)) Blockly.Msg[PREFIX + key] = text;
  termsByType = terms;
}

/** Other names that pupils use for a block, for the search. */
export function searchTerms(type: string): string {
  return termsByType[type] ?? "";
}

/** A text in the current language, with its placeholders replaced by the values. */
export function blockText(key: TextKey, ...values: string[]): string {
  const text = Blockly.Msg[PREFIX + key] ?? "";
  return values.reduce(
    (filled, value, index) => filled.replace(`%${index + 1}`, () => value),
    text,
  );
}

/** Blockly's reference to a text, for definitions made before the language is known. */
export function reference(key: TextKey): string {
  return `%{BKY_${PREFIX}${key}}`;
}
