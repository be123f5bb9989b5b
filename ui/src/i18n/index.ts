import { computed, signal } from "@preact/signals";
import { en } from "./en";
import { es } from "./es";
import type { Language } from "./language";
import { ptBR, type Texts } from "./pt-BR";

export const CATALOGUES: Record<Language, Texts> = { "pt-BR": ptBR, en, es };

export const language = signal<Language>("pt-BR");

/** The words of the page in the language chosen. Reading `.value` in a component subscribes it. */
export const texts = computed<Texts>(() => CATALOGUES[language.value]);

export type { Language, Texts };
