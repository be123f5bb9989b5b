import type { GroupReview } from "../../api/model";
import type { Language } from "../../i18n";

/** The days on which the groups worked, by this PC's calendar, in order. */
export function daysOf(groups: readonly GroupReview[]): Date[] {
  const days = new Set(
    groups.flatMap(({ entries }) => entries.map(({ at }) => dayOf(Date.parse(at) / 1000))),
  );
  return [...days].sort((a, b) => a - b).map((day) => new Date(day * 1000));
}

/** The local midnight before a time; both in seconds since 1970. */
export function dayOf(seconds: number): number {
  return new Date(seconds * 1000).setHours(0, 0, 0, 0) / 1000;
}

/** The days as text: "Quinta-feira, 19 de novembro de 2026", "19 de novembro e 21 de novembro de 2026". */
export function daysText(days: readonly Date[], language: Language): string {
  const last = days.at(-1);
  if (!last) return "";
  const dayTexts = days.map((day) =>
    day.toLocaleDateString(language, {
      ...(days.length === 1 ? { weekday: "long" } : {}),
      day: "numeric",
      month: "long",
      ...(day === last || day.getFullYear() !== last.getFullYear() ? { year: "numeric" } : {}),
    }),
  );
  const text = new Intl.ListFormat(language, { type: "conjunction" }).format(dayTexts);
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/** A short day, such as "19 de nov.", on one line. */
export function shortDay(seconds: number, language: Language): string {
  const day = new Date(seconds * 1000);
  const text = day.toLocaleDateString(language, { day: "numeric", month: "short" });
  return text.replace(/\s/g, "\u00a0");
}
