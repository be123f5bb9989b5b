import { computed, signal } from "@preact/signals";
import type { Language } from "../api/model";
import { compile, type Part } from "./compile";
import { isLanguage, languageRow, SOURCE_LANGUAGE } from "./languages";
import type { Texts } from "./texts";

type PartName = "start" | "lazy";

const START = new Map<Language, object>();
const LAZY = new Map<Language, object>();
/** The texts that the page needs of whatever language it speaks. */
const neededParts = new Set<PartName>(["start"]);

/** The server writes its language into the page, so that its texts arrive with the code. */
const initialTag = document.documentElement.lang;

/** The language chosen; its texts are there. */
export const language = signal<Language>(isLanguage(initialTag) ? initialTag : SOURCE_LANGUAGE);
let latestChoice = language.peek();
const textsVersion = signal(0);

/** The texts of a language that has been fetched; those of lazy parts are missing before one is shown. */
export function textsOf(language: Language): Texts {
  return { ...START.get(language), ...LAZY.get(language) } as Texts;
}

/** The texts of the page in the language chosen. Reading `.value` in a component subscribes it. */
export const texts = computed<Texts>(() => {
  textsVersion.value;
  return textsOf(language.value);
});

/** Fetches what the page needs of a language. Rejects where the server is gone. */
export async function fetchTexts(requested: Language): Promise<void> {
  const row = languageRow(requested);
  if (!START.has(requested)) START.set(requested, compiled(await row.start(), requested));
  if (neededParts.has("lazy") && !LAZY.has(requested))
    LAZY.set(requested, compiled(await row.lazy(), requested));
  textsVersion.value++;
}

const compiled = ({ texts, messages }: Part, language: Language): object => ({
  ...(compile(texts, language) as object),
  ...messages,
});

/** Fetches the texts of the lazy parts in the language chosen. Each language chosen later is fetched with them. */
export async function fetchLazyTexts(): Promise<void> {
  neededParts.add("lazy");
  while (!LAZY.has(language.peek())) await fetchTexts(language.peek());
}

/** Makes the page speak a language as soon as its texts are there; of two choices the last one counts. */
export async function setLanguage(requested: Language): Promise<void> {
  latestChoice = requested;
  await fetchTexts(requested);
  if (latestChoice === requested) language.value = requested;
}

export type { Language, Texts };
