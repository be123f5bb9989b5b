import type { GroupReview } from "../../api/model";
import type { Language } from "../../i18n";

/** The days on which the groups worked, by this PC's calendar, in order. */
export function daysOf(groups: readonly GroupReview[]): Date[] {
  const days = new Set(
    groups.flatMap(({ marks }) => marks.map(({ at }) => dayOf(Date.parse(at) / 1000))),
  );
  return [...days].sort((a, b) => a - b).map((day) => new Date(day * 1000));
}

/** The local midnight before a time; both in seconds since 1970. */
export function dayOf(seconds: number): number {
  return new Date(seconds * 1000).setHours(0, 0, 0, 0) / 1000;
}

/** "Quinta-feira, 19 de novembro de 2026", or "19 de novembro e 21 de novembro de 2026". */
export function daysInWords(days: readonly Date[], language: Language): string {
  const last = days.at(-1);
  if (!last) return "";
  const words = days.map((day) =>
    day.toLocaleDateString(language, {
      ...(days.length === 1 ? { weekday: "long" } : {}),
      day: "numeric",
      month: "long",
      ...(day === last || day.getFullYear() !== last.getFullYear() ? { year: "numeric" } : {}),
    }),
  );
  const said = new Intl.ListFormat(language, { type: "conjunction" }).format(words);
  return said.charAt(0).toUpperCase() + said.slice(1);
}

/** "19 de nov.", on one line. */
export function shortDay(seconds: number, language: Language): string {
  const day = new Date(seconds * 1000);
  const said = day.toLocaleDateString(language, { day: "numeric", month: "short" });
  return said.replace(/\s/g, "\u00a0");
}
