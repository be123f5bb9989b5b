import type { Language } from "../../../i18n";

/** A day, "2026-11-18", as the language writes it: "18/11/2026". */
export function dayText(day: string, language: Language): string {
  if (!day) return "";
  const form = { day: "2-digit", month: "2-digit", year: "numeric" } as const;
  return new Date(`${day}T12:00`).toLocaleDateString(language, form);
}

/**
 * Reads a day as people write it: "18/11/2026", "18.11.26", or "18/11" of this year. Returns
 * "2026-11-18", or null if there is no such day.
 */
export function readDay(text: string, language: Language, today = new Date()): string | null {
  const [first = 0, second = 0, third = today.getFullYear()] = (text.match(/\d+/g) ?? []).map(
    Number,
  );
  const [day, month] = language === "en" ? [second, first] : [first, second];
  const year = third < 100 ? 2000 + third : third;
  // noon: no time zone makes another day of it
  const date = new Date(Date.UTC(year, month - 1, day, 12));
  const exists = date.getUTCMonth() === month - 1 && date.getUTCDate() === day;
  return exists && year < 3000 ? date.toISOString().slice(0, 10) : null;
}
