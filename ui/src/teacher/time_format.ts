import type { Language } from "../i18n";

/** Weekday, day and time, by the clock of this PC; with the year unless it is the current one. */
export function dateAndTime(iso: string, language: Language): string {
  const date = new Date(iso);
  const day = date.toLocaleDateString(language, {
    weekday: "short",
    day: "numeric",
    month: "short",
    ...(date.getFullYear() !== new Date().getFullYear() && { year: "numeric" }),
  });
  return `${day}, ${timeOfDay(iso, language)}`;
}

/** The time of day, by the clock of this PC, in the format of `dateAndTime`. */
export function timeOfDay(iso: string, language: Language): string {
  return new Date(iso).toLocaleTimeString(language, { timeStyle: "short" });
}

/** A duration without fractions of a second: "40 s", "2 min 05 s", "1 h 10 min". */
export function roundDuration(seconds: number, language: Language): string {
  const whole = Math.round(seconds);
  if (whole < 60) return `${whole}\u00a0s`;
  const minutes = Math.floor(whole / 60);
  if (minutes < 60) {
    const rest = whole % 60;
    return rest && minutes < 10
      ? `${minutes}\u00a0min ${String(rest).padStart(2, "0")}\u00a0s`
      : `${minutes}\u00a0min`;
  }
  const hours = Math.floor(minutes / 60);
  return `${hours.toLocaleString(language)}\u00a0h ${String(minutes % 60).padStart(2, "0")}\u00a0min`;
}
