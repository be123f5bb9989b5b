import type { Language, Texts } from "../i18n";
import { formatNumber, listSeparator } from "../i18n/format";

const NUMBER = /^-?\d+(\.\d+)?(e[-+]?\d+)?$/;
const NUMBER_INSIDE = /(^|[^\p{L}\d.,])(-?\d+\.\d+(?:e[-+]?\d+)?)(?![\p{L}\d]|[.,]\d)/gu;
/** Inside a text, "1.500" may be a number of a person, with a point between the thousands. */
const THOUSANDS = /^-?[1-9]\d{0,2}\.\d{3}$/;

/**
 * A message of the robot with its numbers in the format of the language. A program writes numbers
 * with a point and all digits.
 */
export function localizeNumbers(text: string, language: Language): string {
  const parts = text.split(", ");
  if (parts.every((part) => isWrittenByProgram(part))) {
    return parts.map((part) => formatNumber(Number(part), language)).join(separatorIn(language));
  }
  return text.replace(NUMBER_INSIDE, (whole, before: string, number: string) =>
    isWrittenByProgram(number) && !THOUSANDS.test(number)
      ? before + formatNumber(Number(number), language)
      : whole,
  );
}

/** A text that the robot says, or a number, in the format of the language. */
export function spokenText(text: string | number, language: Language): string {
  return typeof text === "number" ? formatNumber(text, language) : localizeNumbers(text, language);
}

/** A program writes no trailing zeros; a pupil typed a number that has some. */
const isWrittenByProgram = (text: string) =>
  NUMBER.test(text) && (text.includes("e") || String(Number(text)) === text);

const separatorIn = (language: Language) => `${listSeparator(language)} `;

/** Formats a program's value for the watch panel: texts in quotes, numbers in the language's format. */
export function valueText(value: unknown, texts: Texts, language: Language): string {
  if (typeof value === "number") return formatNumber(value, language);
  if (typeof value === "boolean") return value ? texts.show.yes : texts.show.no;
  if (value === "") return texts.show.emptyText;
  if (typeof value === "string") return texts.show.quoted({ text: value });
  if (Array.isArray(value)) {
    const items = value.map((item) => valueText(item, texts, language));
    return `[${items.join(separatorIn(language))}]`;
  }
  return JSON.stringify(value) ?? "";
}
