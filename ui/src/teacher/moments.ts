import { language } from "../i18n";

/** Day and time, as the clock of the PC had it where it was written down. */
export function momentOf(iso: string): string {
  return new Date(iso).toLocaleString(language.value, {
    weekday: "short",
    day: "numeric",
    month: "short",
    hour: "2-digit",
    minute: "2-digit",
    ...(new Date(iso).getFullYear() !== new Date().getFullYear() && { year: "numeric" }),
  });
}
