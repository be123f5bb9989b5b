import { type Language, textsOf } from ".";
import { pluralForm } from "./compile";
import { formatNumber } from "./format";
import type { Message, MessageEntry } from "./message";

/**
 * Why a run ended, in the server's words; null for a code that has none. The code can be that of a fault of the program,
 * because some values are known only in the run, such as a computed distance below 0.
 */
export function reasonText(
  code: string | null,
  params: Record<string, unknown>,
  language: Language,
): Message | null {
  return formatMessage(
    code === null ? undefined : textsOf(language).reasons[code],
    params,
    language,
  );
}

/** The name of a kind of real robot, and what it is as the remedy; null for that of a newer release. */
export const linkText = (link: string, language: Language): Message | null =>
  reasonText(`robot_link_${link}`, {}, language);

/** What is wrong with the camera or with the recording of a sign; null for a code that has no words there. */
export function cameraProblemText(
  code: string,
  params: Record<string, unknown>,
  language: Language,
): Message | null {
  return formatMessage(textsOf(language).cameraProblems?.[code], params, language);
}

/** What a number of the review counts; null for that of a newer release. */
export const knownMetricText = (name: string, language: Language): Message | null =>
  formatMessage(textsOf(language).figures?.[`figure_${name}`], {}, language);

/** Measured lengths, which are rounded to two decimals. Numbers of the program stay as they are written. */
const MEASURED = new Set(["done", "away"]);
/** Their sign says to which side the robot turned. */
const SIDED = new Set(["done", "amount"]);

function formatMessage(
  entry: MessageEntry | undefined,
  params: Record<string, unknown>,
  language: Language,
): Message | null {
  if (!entry) return null;
  const side = "unit" in params && Number(params.amount) < 0 ? -1 : 1; // "77 of 90", not "−77 of −90"
  const fill = (text: string) =>
    text.replace(/\{\{(\w+)\}\}/g, (whole, name: string) => {
      if (!(name in params)) return whole;
      const { [name]: value } = params;
      if (typeof value !== "number") return formatValue(value, language);
      const size = SIDED.has(name) ? side * value : value;
      return formatValue(MEASURED.has(name) ? Math.round(size * 100) / 100 : size, language);
    });
  const form = (part: keyof Message) => entry[part] ?? pluralOf(entry, part, params, language);
  return { message: fill(form("message")), remedy: fill(form("remedy")) };
}

/** The form of a plural for the first number in its general form, as `_form` of pinel_desktop/messages chooses it. */
function pluralOf(
  words: MessageEntry,
  part: keyof Message,
  params: Record<string, unknown>,
  language: Language,
): string {
  const names = words[`${part}_other`]?.matchAll(/\{\{(\w+)\}\}/g) ?? [];
  const count = [...names].map(([, name = ""]) => params[name]).find(Number.isInteger);
  return pluralForm({ ...words }, part, Number(count ?? Number.NaN), language);
}

function formatValue(value: unknown, language: Language): string {
  if (typeof value === "number") return formatNumber(value, language);
  if (Array.isArray(value)) return value.map((item) => formatValue(item, language)).join(", ");
  return typeof value === "string" ? value : JSON.stringify(value);
}
