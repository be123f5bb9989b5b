import { texts } from "../../i18n";
import type { Message } from "../../i18n/message";

/** Text of a metric from the server's catalogue, which the exported table uses too. */
export function metricText(name: string): Message {
  return texts.value.figures[`figure_${name}`] ?? { message: name, remedy: "" };
}
