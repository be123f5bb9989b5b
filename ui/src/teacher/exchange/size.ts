import type { Language } from "../../i18n";
import { decimal } from "../../i18n/format";

const UNITS = ["KB", "MB", "GB", "TB"] as const;

/** A size as text, such as "340 KB" or "1,2 GB". 0 is "0 KB"; any other size is at least 1 KB. */
export function size(bytes: number, language: Language): string {
  let value = bytes > 0 ? Math.max(1, bytes / 1000) : 0;
  let unit = 0;
  while (value >= 999.5 && unit < UNITS.length - 1) {
    value /= 1000;
    unit += 1;
  }
  return `${decimal(value, value < 10 && unit > 0 ? 1 : 0, language)}\u00a0${UNITS[unit]}`;
}
