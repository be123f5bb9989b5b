import type { Language } from "../i18n";
import { reasonText } from "../i18n/reasons";
import type { Ending, RunView } from "./reducer";

/** The block at which a run failed and the text of the reason, in the form that an editor shows. */
export interface Failure {
  block: string;
  message: string;
  remedy: string;
}

/** The failure of a run as a list; empty if the run did not fail or the failure has no block. */
export function failureIn({ phase, ending }: RunView, language: Language): Failure[] {
  return phase === "failed" ? failureOf(ending, language) : [];
}

export function failureOf(ending: Ending | null, language: Language): Failure[] {
  if (!ending?.block) return [];
  const explanation = reasonText(ending.reason, ending.params, language);
  return explanation ? [{ block: ending.block, ...explanation }] : [];
}
