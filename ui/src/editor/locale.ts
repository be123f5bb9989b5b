import * as Blockly from "blockly/core";
import * as en from "blockly/msg/en";
import * as es from "blockly/msg/es";
import * as ptBR from "blockly/msg/pt-br";
import { setBlockLanguage } from "../blocks/texts";
import type { Language } from "../i18n/language";
import { OWN_MESSAGES } from "./messages";

const BLOCKLY_MESSAGES: Readonly<Record<Language, object>> = { "pt-BR": ptBR, en, es };

/** Blockly's own words and those of our blocks; what is drawn already keeps its old ones until it is made again. */
export function applyLanguage(language: Language): void {
  Blockly.setLocale({
    ...(BLOCKLY_MESSAGES[language] as Record<string, string>),
    ...OWN_MESSAGES[language],
  });
  setBlockLanguage(language);
}
