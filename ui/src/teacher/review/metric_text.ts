import { language } from "../../i18n";
import type { Message } from "../../i18n/message";
import { knownMetricText } from "../../i18n/reasons";

/** Text of a metric from the server's catalogue, which the exported table uses too. */
export function metricText(name: string): Message {
  return knownMetricText(name, language.value) ?? { message: name, remedy: "" };
}
