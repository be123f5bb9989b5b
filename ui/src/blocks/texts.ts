import * as Blockly from "blockly/core";
import { type Language, type Texts, textsOf } from "../i18n";

export type TextKey = keyof Texts["blocks"];

const PREFIX = "PINEL_";

let termsByType: Readonly<Record<string, string>> = {};

/** Puts our words where Blockly looks for them; blocks made from now on speak this language. */
export function setBlockLanguage(language: Language): void {
  const { blocks, searchTerms: terms } = textsOf(language);
  for (const [key, text] of Object.entries(blocks)) Blockly.Msg[PREFIX + key] = text;
  termsByType = terms;
}

/** What pupils call a block besides the words on it. */
export function searchTerms(type: string): string {
  return termsByType[type] ?? "";
}

/** A word of the current language, its placeholders filled in. */
export function blockText(key: TextKey, ...values: string[]): string {
  const text = Blockly.Msg[PREFIX + key] ?? "";
  return values.reduce(
    (filled, value, index) => filled.replace(`%${index + 1}`, () => value),
    text,
  );
}

/** How a definition refers to a word before the language is known. */
export function reference(key: TextKey): string {
  return `%{BKY_${PREFIX}${key}}`;
}
