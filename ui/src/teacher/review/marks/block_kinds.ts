import { CATEGORIES, DEFINITIONS } from "../blocks/definitions";
import { BLOCK_TEXTS } from "../blocks/texts";
import type { TextKey } from "../blocks/texts/keys";
import { CATEGORY_COLOURS, type Category } from "../design/categories";
import type { Language } from "../i18n/language";

const CATEGORY_OF = new Map<string, Category>(
  CATEGORIES.flatMap((category) =>
    category in CATEGORY_COLOURS
      ? DEFINITIONS[category].map(({ type }) => [type as string, category as Category] as const)
      : [],
  ),
);

/** The category of a type of block; null for blocks of another release. */
export const categoryOfType = (type: string): Category | null => CATEGORY_OF.get(type) ?? null;

export const categoryName = (category: Category, language: Language): string =>
  BLOCK_TEXTS[language][`CATEGORY_${category.toUpperCase()}` as TextKey] ?? category;
