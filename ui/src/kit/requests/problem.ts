import { ApiError, ServerUnreachable } from "../../api/errors";
import { texts } from "../../i18n";

/** Text of a failure: message and remedy; `details` is for a technician. */
export interface Problem {
  message: string;
  remedy: string;
  details?: string;
}

/** An action refused by the page, with its text. */
export class Refused extends Error {
  constructor(
    message: string,
    readonly remedy: string,
  ) {
    super(message);
  }
}

/** The text of any error. */
export function problemOf(error: unknown): Problem {
  if (error instanceof Refused) return { message: error.message, remedy: error.remedy };
  if (error instanceof ApiError && error.message) {
    return { message: error.message, remedy: error.remedy, details: error.details };
  }
  const { trouble } = texts.value;
  if (error instanceof ServerUnreachable)
    return { message: trouble.goneTitle, remedy: trouble.gone };
  return { message: trouble.failedTitle, remedy: "" };
}
