/** The languages of the page; Portuguese is the first and the one to fall back on. */
export const LANGUAGES = ["pt-BR", "en", "es"] as const;

export type Language = (typeof LANGUAGES)[number];

export function isLanguage(value: unknown): value is Language {
  return (LANGUAGES as readonly unknown[]).includes(value);
}
