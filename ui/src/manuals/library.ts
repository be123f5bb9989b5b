import { rows } from "virtual:manuals";
import { signal } from "@preact/signals";
import { type Language, language } from "../i18n";
import { SOURCE_LANGUAGE } from "../i18n/languages";
import { type Loadable, useLoaded } from "../kit/requests/useLoaded";
import type { Manual } from "./model";

/** The languages that have manuals. */
export const MANUAL_LANGUAGES = Object.keys(rows) as Language[];

/** The language chosen for the manuals where they do not exist in that of the page. */
export const chosenLanguage = signal<Language>(SOURCE_LANGUAGE);

/** The language of the manuals: that of the page if it has them. */
export function manualLanguage(): Language {
  return MANUAL_LANGUAGES.find((one) => one === language.value) ?? chosenLanguage.value;
}

/** All manuals, in the order of their list. */
export function useManuals(): Loadable<readonly Manual[]> {
  const now = manualLanguage();
  return useLoaded(now, async () => (await rows[now]?.())?.manuals ?? []);
}
