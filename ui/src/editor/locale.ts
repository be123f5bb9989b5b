import * as Blockly from "blockly/core";
import { setBlockLanguage } from "../blocks/texts";
import { type Language, textsOf } from "../i18n";

/**
 * Sets the language of Blockly's texts and of our blocks. Drawn blocks change only when they are
 * recreated.
 */
export function applyLanguage(language: Language): void {
  Blockly.setLocale({ ...textsOf(language).blockly });
  setBlockLanguage(language);
}
