import type { Language } from "./language";

interface Words {
  message: string;
  remedy: string;
}

type Area = Record<string, Record<Language, Words>>;

/**
 * The server's own words for the ends of runs, so that no text exists twice. What can be known only while running may
 * have the reason of a fault of the document, such as a distance that comes out below 0.
 */
const AREAS = import.meta.glob<Area>(
  "../../../pinel_desktop/messages/catalogue/{program,run}.json",
  { eager: true, import: "default" },
);

const CATALOGUE: Area = Object.assign({}, ...Object.values(AREAS));

/** Why a run ended, in words; null for a code that has none. */
export function reasonWords(
  code: string | null,
  params: Record<string, unknown>,
  language: Language,
): Words | null {
  const words = code === null ? undefined : CATALOGUE[code]?.[language];
  if (!words) return null;
  const fill = (text: string) =>
    text.replace(/\{(\w+)\}/g, (whole, name: string) =>
      name in params ? show(params[name], language) : whole,
    );
  return { message: fill(words.message), remedy: fill(words.remedy) };
}

function show(value: unknown, language: Language): string {
  if (typeof value === "number") {
    return value.toLocaleString(language, { maximumFractionDigits: 3, useGrouping: false });
  }
  if (Array.isArray(value)) return value.map((item) => show(item, language)).join(", ");
  return typeof value === "string" ? value : JSON.stringify(value);
}
