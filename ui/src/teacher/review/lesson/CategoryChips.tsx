import type { BlockCount } from "../../../api/model";
import type { Category } from "../../../blocks/categories";
import { language, texts } from "../../../i18n";
import { categoryName, categoryOfType, hueOf } from "../timeline_entries/block_kinds";

/** Maximum number of categories whose names fit. */
const FEW = 2;

interface CategoryChipsProps {
  blocks: readonly BlockCount[];
}

/** Number of blocks in use by category, compact. */
export function CategoryChips({ blocks }: CategoryChipsProps) {
  const { detail } = texts.value.review;
  const counts = new Map<Category, number>();
  for (const { type, count } of blocks) {
    const category = categoryOfType(type);
    if (category && count > 0) counts.set(category, (counts.get(category) ?? 0) + count);
  }
  return (
    <ul class="chips row wrap gap-1" aria-label={detail.blocks}>
      {[...counts].map(([category, count]) => {
        const name = counts.size > FEW ? "" : `${categoryName(category, language.value)} `;
        const label = detail.blocksOf({ category: categoryName(category, language.value), count });
        return (
          <li key={category} class="chip chip--small" style={hueOf(category)} title={label}>
            <span aria-hidden="true">
              {name}
              {count}
            </span>
            <span class="visually-hidden">{label}</span>
          </li>
        );
      })}
    </ul>
  );
}
