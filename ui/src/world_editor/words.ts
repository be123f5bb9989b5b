import { BLOCK_TEXTS } from "../blocks/texts";
import type { TextKey } from "../blocks/texts/keys";
import type { Language, Texts } from "../i18n";
import { ofKind, type Plan, type Thing } from "./plan";

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

/** What a thing is called: "Parede 2", "Lugar A". */
export function nameOf(plan: Plan, thing: Thing, words: Texts["world"]): string {
  const name =
    thing.kind === "zone" ? thing.name : `${ofKind(plan, thing.kind).indexOf(thing) + 1}`;
  return `${words.kinds[thing.kind]} ${name}`;
}
