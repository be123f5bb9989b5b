import type { Level } from "../../blocks/definition";
import { ALL_DEFINITIONS } from "../../blocks/definitions";

/** Words between quotation marks of any kind. */
const QUOTED = /[“"„«‘']([^“”"„«»‘’']{2,60})[”"»’']/g;

/**
 * Names of blocks in a hint that its level does not offer: what stands in quotation marks and begins a block's words.
 * `labelOf` gives the words on a block of that type.
 */
export function blocksNotOffered(
  hint: string,
  level: Level,
  labelOf: (type: string) => string,
): string[] {
  const named = [...hint.matchAll(QUOTED)].map((match) => match[1] ?? "");
  return named.filter((name) => {
    const prefix = plain(name);
    const found = ALL_DEFINITIONS.filter(
      ({ type, hidden }) =>
        !hidden && prefix && `${plain(labelOf(type))} `.startsWith(`${prefix} `),
    );
    return found.length > 0 && found.every((one) => one.level > level);
  });
}

/** Without placeholders, numbers, accents and capitals. */
function plain(text: string): string {
  return text
    .normalize("NFD")
    .replace(/\p{M}/gu, "")
    .toLowerCase()
    .replace(/%\d+|[^\p{L} ]/gu, " ")
    .replace(/\s+/g, " ")
    .trim();
}
