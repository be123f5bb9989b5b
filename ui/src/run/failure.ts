import type { Language } from "../i18n/language";
import { reasonWords } from "../i18n/reasons";
import type { Ending, RunView } from "./reducer";

/** The block at which a run broke off, with why, in words, as an editor shows it. */
export interface Failure {
  block: string;
  message: string;
  remedy: string;
}

/** None where the run did not break off, or at no block. */
export function failureIn({ phase, ending }: RunView, language: Language): Failure[] {
  return phase === "failed" ? failureOf(ending, language) : [];
}

export function failureOf(ending: Ending | null, language: Language): Failure[] {
  if (!ending?.block) return [];
  const words = reasonWords(ending.reason, ending.params, language);
  return words ? [{ block: ending.block, ...words }] : [];
}
