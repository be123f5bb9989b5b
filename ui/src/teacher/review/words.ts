import { texts } from "../../i18n";
import type { Message } from "../../i18n/message";

/** What a figure counts, in the words of the server's catalogue, which the exported table uses too. */
export function figureWords(name: string): Message {
  return texts.value.figures[`figure_${name}`] ?? { message: name, remedy: "" };
}
