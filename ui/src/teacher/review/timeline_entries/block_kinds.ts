import { CATEGORY_COLOURS, type Category } from "../../../blocks/categories";
import { CATEGORIES, DEFINITIONS } from "../../../blocks/definitions";
import type { TextKey } from "../../../blocks/texts";
import { type Language, textsOf } from "../../../i18n";

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
  textsOf(language).blocks[`CATEGORY_${category.toUpperCase()}` as TextKey] ?? category;

/** CSS style with the colour of a category. */
export const hueOf = (category: Category) => ({ "--hue": CATEGORY_COLOURS[category] });
