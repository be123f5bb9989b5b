import type { Level } from "../../blocks/definition";
import { ALL_DEFINITIONS } from "../../blocks/definitions";

/** Text between quotation marks of any kind. */
const QUOTED = /[“"„«‘']([^“”"„«»‘’']{2,60})[”"»’']/g;

/**
 * Blocks that a hint names but its level does not offer. A hint names a block if a text in quotation
 * marks is the beginning of the block's label. `labelOf` returns the label of a type of block.
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

/** A text without placeholders, numbers, accents and capitals. */
function plain(text: string): string {
  return text
    .normalize("NFD")
    .replace(/\p{M}/gu, "")
    .toLowerCase()
    .replace(/%\d+|[^\p{L} ]/gu, " ")
    .replace(/\s+/g, " ")
    .trim();
}
