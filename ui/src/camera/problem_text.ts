import type { CameraProblem } from "../api/model";
import { language } from "../i18n";
import type { Message } from "../i18n/message";
import { cameraProblemText } from "../i18n/reasons";

/**
 * A problem in the language of the page. If the page has no text for its code, gives the server's.
 */
export function problemText(problem: CameraProblem): Message {
  return cameraProblemText(problem.code, problem.params, language.value) ?? problem;
}
