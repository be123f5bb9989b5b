import type { Language, Texts } from "../i18n";

/** Formats a number for the language, without trailing zeros. */
export function numberWords(value: number, language: Language): string {
  const digits = { maximumFractionDigits: 4, useGrouping: false } as const;
  return value.toLocaleString(language, digits).replace("-", "\u2212");
}

/** Formats a program's value for the watch panel: texts in quotes, numbers in the language's format. */
export function valueWords(value: unknown, texts: Texts, language: Language): string {
  if (typeof value === "number") return numberWords(value, language);
  if (typeof value === "boolean") return value ? texts.show.yes : texts.show.no;
  if (typeof value === "string") return value === "" ? texts.show.emptyText : `“${value}”`;
  if (Array.isArray(value)) {
    const separator = language === "en" ? ", " : "; ";
    return `[${value.map((item) => valueWords(item, texts, language)).join(separator)}]`;
  }
  return JSON.stringify(value) ?? "";
}
