import type { Language } from "../api/model";
import type { Texts } from "./texts";

const cache = new Map<string, Intl.NumberFormat>();

/** A number as people of the language write it, always with `digits` decimals. */
export function decimal(value: number, digits: number, language: Language): string {
  const key = `${language}/${digits}`;
  let format = cache.get(key);
  if (!format) {
    format = new Intl.NumberFormat(language, {
      minimumFractionDigits: digits,
      maximumFractionDigits: digits,
      signDisplay: "negative",
    });
    cache.set(key, format);
  }
  return format.format(value).replace("-", "\u2212");
}

/** What separates the decimals of a number. */
export const decimalPoint = (language: Language) => decimal(0.5, 1, language).charAt(1);

/** What separates numbers in a list or a table: a semicolon where numbers have a decimal comma. */
export const listSeparator = (language: Language) => (decimalPoint(language) === "," ? ";" : ",");

/** A number as people of the language write it, without trailing zeros and without the digits that no pupil measures. */
export function formatNumber(value: number, language: Language): string {
  const digits = { ...sensibleDigits(value), useGrouping: false };
  return value.toLocaleString(language, digits).replace("-", "\u2212");
}

/** Four decimals where the number has no more, as 0.125; otherwise two, and two digits of what is below 0.1. */
function sensibleDigits(value: number): Intl.NumberFormatOptions {
  const isShort = Math.abs(value - Math.round(value * 1e4) / 1e4) < 1e-9;
  if (isShort) return { maximumFractionDigits: 4 };
  return Math.abs(value) < 0.1 ? { maximumSignificantDigits: 2 } : { maximumFractionDigits: 2 };
}

/** A probability in whole per cent; nothing that was measured is said to be certain. */
export function percent(part: number, language: Language): string {
  const shown = Math.min(0.99, Math.floor(100 * part) / 100);
  return shown.toLocaleString(language, { style: "percent" });
}

export const metres = (value: number, language: Language) =>
  `${decimal(value, 2, language)}\u00a0m`;

export const seconds = (value: number, language: Language) =>
  `${decimal(value, 1, language)}\u00a0s`;

export const degrees = (value: number, language: Language) => `${decimal(value, 0, language)}°`;

/** Radians as degrees in (-180, 180], the way headings are told. */
export function headingDegrees(yaw: number): number {
  const turned = (yaw * 180) / Math.PI;
  const wrapped = turned - 360 * Math.ceil((turned - 180) / 360);
  if (wrapped < -179.5) return 180;
  return Math.abs(wrapped) < 0.05 ? 0 : wrapped;
}

/** How long something took: "17,2 s", "2 min 05 s"; a line never breaks inside it. */
export function duration(total: number, language: Language): string {
  if (total < 60) return seconds(total, language);
  const minutes = Math.floor(total / 60);
  const rest = String(Math.floor(total % 60)).padStart(2, "0");
  return `${minutes}\u00a0min\u00a0${rest}\u00a0s`;
}

/** When something was, the way one would say it on that day: "há 5 min", "hoje, 14:06", "19 de nov., 14:06". */
export function relativeTime(iso: string, now: Date, language: Language, texts: Texts): string {
  const minutes = Math.floor((now.getTime() - new Date(iso).getTime()) / 60_000);
  if (minutes >= 0 && minutes < 1) return texts.units.now;
  if (minutes >= 0 && minutes < 60) return texts.units.minutesAgo({ n: minutes });
  return relativeDateAndTime(iso, now, language, texts);
}

/** The date as `relativeTime` writes it, always with the time of day: for lists in which the time tells entries apart. */
export function relativeDateAndTime(
  iso: string,
  now: Date,
  language: Language,
  texts: Texts,
): string {
  const then = new Date(iso);
  const time = whole(then.toLocaleTimeString(language, { timeStyle: "short" }));
  const days = dayNumber(now) - dayNumber(then);
  if (days === 0) return texts.units.today({ time });
  if (days === 1) return texts.units.yesterday({ time });
  const sameYear = then.getFullYear() === now.getFullYear();
  const day = then.toLocaleDateString(language, {
    day: "numeric",
    month: "short",
    ...(sameYear ? {} : { year: "numeric" }),
  });
  return `${whole(day)}, ${time}`;
}

/** A text that stays on one line. */
const whole = (text: string) => text.replace(/\s/g, "\u00a0");

function dayNumber(date: Date): number {
  return Math.round(
    new Date(date.getFullYear(), date.getMonth(), date.getDate()).getTime() / 864e5,
  );
}
