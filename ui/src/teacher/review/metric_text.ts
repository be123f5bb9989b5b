import { texts } from "../../i18n";
import type { Message } from "../../i18n/message";

/** Text of a figure from the server's catalogue, also used by the exported table. */
export function metricText(name: string): Message {
  return texts.value.figures[`figure_${name}`] ?? { message: name, remedy: "" };
}
