import { BLOCK_TEXTS } from "../blocks/texts";
import type { TextKey } from "../blocks/texts/keys";
import type { Language, Texts } from "../i18n";
import type { Thing } from "./plan";

/** The floor's colours in the order of the rainbow; `blocks` has their words. */
export const COLORS = [
  "red",
  "orange",
  "yellow",
  "green",
  "blue",
  "purple",
  "black",
  "white",
] as const;

export function colorWord(color: string, language: Language): string {
  const known = COLORS.find((one) => one === color);
  return known ? BLOCK_TEXTS[language][`COLOUR_${known.toUpperCase()}` as TextKey] : color;
}

/** What a thing is called: "Parede 2", "Lugar A". `index` is its place among its kind. */
export function nameOf(thing: Thing, index: number, words: Texts["world"]): string {
  return `${words.kinds[thing.kind]} ${thing.kind === "zone" ? thing.name : index + 1}`;
}
