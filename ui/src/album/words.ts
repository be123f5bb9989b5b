import type { Sticker } from "../api/model";
import type { Language, Texts } from "../i18n";
import { isCharacter } from "./stickers";

/** The name of a sticker: the title of its activity, or what a group did in its own way. */
export const titleOf = ({ name, title }: Sticker, { album }: Texts) =>
  isCharacter(name) ? album.names[name] : title;

/** What to do for an empty place, in one sentence. */
export function howOf({ name }: Sticker, { album }: Texts): string {
  const sentences: Readonly<Record<string, string>> = album.how;
  return sentences[name] ?? album.own;
}

/** A day by the clock of this PC; with the year unless it is the current one. */
export function dayOf(iso: string, language: Language, now = new Date()): string {
  const day = new Date(iso);
  return day.toLocaleDateString(language, {
    day: "numeric",
    month: "short",
    ...(day.getFullYear() !== now.getFullYear() && { year: "numeric" }),
  });
}
