import type { Language } from "../api/model";
import type { LazyTexts, StartTexts } from "./texts";

/** A language: what it calls itself, and its texts, each fetched when it is needed. */
export interface LanguageRow {
  readonly name: string;
  readonly start: () => Promise<StartTexts>;
  readonly lazy: () => Promise<LazyTexts>;
}

/** The language that the others are translated from, and the one to fall back on. */
export const FIRST: Language = "pt-BR";

const FOLDERS = import.meta.glob<LanguageRow>("./*/index.ts", { eager: true, import: "row" });

const byTag = new Map(
  Object.entries(FOLDERS).map(([path, row]) => [path.split("/")[1] as Language, row]),
);

/** One for each folder beside this file, the first language first. */
export const LANGUAGES = [FIRST, ...[...byTag.keys()].filter((tag) => tag !== FIRST)];

export function languageRow(language: Language): LanguageRow {
  const row = byTag.get(language);
  if (!row) throw new Error(`there is no folder ${language}`);
  return row;
}

export function isLanguage(value: unknown): value is Language {
  return byTag.has(value as Language);
}
