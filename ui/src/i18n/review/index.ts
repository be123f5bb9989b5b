import { computed } from "@preact/signals";
import { language } from "..";
import type { Language } from "../language";
import { en } from "./en";
import { es } from "./es";
import { ptBR, type ReviewTexts } from "./pt-BR";

export const REVIEW_TEXTS: Record<Language, ReviewTexts> = { "pt-BR": ptBR, en, es };

/**
 * The words of the teacher's review. They are not part of the page's catalogue: pupils never see them, and the page
 * would have to read them before it starts.
 */
export const words = computed<ReviewTexts>(() => REVIEW_TEXTS[language.value]);

interface Figure {
  message: string;
  remedy: string;
}

const [CATALOGUE] = Object.values(
  import.meta.glob<Record<string, Record<Language, Figure>>>(
    "../../../../pinel_desktop/messages/catalogue/review.json",
    { eager: true, import: "default" },
  ),
);

/** What a number counts, in the server's own words, so that page and table say the same. */
export function figureWords(name: string): Figure {
  return CATALOGUE?.[`figure_${name}`]?.[language.value] ?? { message: name, remedy: "" };
}
