import { ApiError, ServerGone } from "../../api/errors";
import { texts } from "../../i18n";

/** A failure in words: what happened and what to do next. */
export interface Problem {
  message: string;
  remedy: string;
}

/** What the page itself refuses to do, in words. */
export class Refused extends Error {
  constructor(
    message: string,
    readonly remedy: string,
  ) {
    super(message);
  }
}

/** The words for any error. */
export function wordsOf(error: unknown): Problem {
  if (error instanceof Refused) return { message: error.message, remedy: error.remedy };
  if (error instanceof ApiError && error.message) {
    return { message: error.message, remedy: error.remedy };
  }
  const { trouble } = texts.value;
  if (error instanceof ServerGone) return { message: trouble.goneTitle, remedy: trouble.gone };
  return { message: trouble.failedTitle, remedy: "" };
}
