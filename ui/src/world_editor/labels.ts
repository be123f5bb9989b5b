import type { TextKey } from "../blocks/texts";
import { type Language, type Texts, textsOf } from "../i18n";
import type { WorldObject } from "./plan";

/** Colours of the floor in rainbow order; `blocks` has their names. */
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

export function colorLabel(color: string, language: Language): string {
  const known = COLORS.find((one) => one === color);
  return known ? textsOf(language).blocks[`COLOUR_${known.toUpperCase()}` as TextKey] : color;
}

/** Display name of an object, such as "Parede 2" or "Lugar A". `index` is its index among objects of its kind. */
export function nameOf(object: WorldObject, index: number, labels: Texts["world"]): string {
  return `${labels.kinds[object.kind]} ${object.kind === "zone" ? object.name : index + 1}`;
}
