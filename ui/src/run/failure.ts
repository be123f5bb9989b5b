import type { Language } from "../i18n";
import { reasonWords } from "../i18n/reasons";
import type { Ending, RunView } from "./reducer";

/** The block at which a run failed and the reason in words, in the form that an editor shows. */
export interface Failure {
  block: string;
  message: string;
  remedy: string;
}

/** The failure of a run as a list; empty where the run did not fail, or not at a block. */
export function failureIn({ phase, ending }: RunView, language: Language): Failure[] {
  return phase === "failed" ? failureOf(ending, language) : [];
}

export function failureOf(ending: Ending | null, language: Language): Failure[] {
  if (!ending?.block) return [];
  const explanation = reasonWords(ending.reason, ending.params, language);
  return explanation ? [{ block: ending.block, ...explanation }] : [];
}
