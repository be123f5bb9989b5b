import { type LanguageRow, rows } from "virtual:languages";
import type { Language } from "../api/model";

/** The language that the others are translated from, and the one to fall back on. */
export const SOURCE_LANGUAGE: Language = "pt-BR";

/** One for each folder of the catalogue, the first language first. */
export const LANGUAGES = [
  SOURCE_LANGUAGE,
  ...(Object.keys(rows) as Language[]).filter((tag) => tag !== SOURCE_LANGUAGE),
];

export function languageRow(language: Language): LanguageRow {
  const { [language]: row } = rows;
  if (!row) throw new Error(`there is no folder ${language}`);
  return row;
}

export function isLanguage(value: unknown): value is Language {
  return typeof value === "string" && Object.hasOwn(rows, value);
}
