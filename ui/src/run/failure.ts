import type { Language } from "../i18n";
import { reasonText } from "../i18n/reasons";
import type { Ending, RunView } from "./reducer";
import type { Sentence } from "./sentence";

/**
 * The block at which a run failed and the text of the reason, in the form that an editor shows.
 * The sentence of the run says what happened, the block what to do.
 */
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
  if (!explanation) return [];
  const { message, remedy } = explanation;
  return [{ block: ending.block, message: remedy || message, remedy: "" }];
}

/** The sentence of a run whose failure is shown at its block: what to do is only written there. */
export function besideBlock(sentence: Sentence, [failure]: readonly Failure[]): Sentence {
  const isAtBlock = failure !== undefined && failure.message === sentence.detail;
  return isAtBlock ? { ...sentence, isAtBlock } : sentence;
}
