import { CATEGORY_COLOURS, type Category } from "../design/categories";
import { language } from "../i18n";
import { words } from "../i18n/review";
import { categoryName, categoryOfType } from "./block_kinds";
import { blockName } from "./difference_words";
import type { BlockCount } from "./model";

/** So many categories have room for their names. */
const FEW = 2;

/** How many blocks of each category are in use, small. */
export function CategoryChips({ blocks }: { blocks: readonly BlockCount[] }) {
  const { detail } = words.value;
  const counts = new Map<Category, number>();
  for (const { type, count } of blocks) {
    const category = categoryOfType(type);
    if (category && count > 0) counts.set(category, (counts.get(category) ?? 0) + count);
  }
  return (
    <ul class="chips" aria-label={detail.blocks}>
      {[...counts].map(([category, count]) => {
        const name = counts.size > FEW ? "" : `${categoryName(category, language.value)} `;
        const label = detail.blocksOf(categoryName(category, language.value), count);
        return (
          <li key={category} class="chip chip--small" style={hue(category)} title={label}>
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

/** Every type of block in use with its words. */
export function BlockChips({ blocks }: { blocks: readonly BlockCount[] }) {
  const { detail } = words.value;
  if (blocks.length === 0) return <p class="detail__none">{detail.noBlocks}</p>;
  return (
    <ul class="chips">
      {blocks.map(({ type, count, loose }) => {
        const category = categoryOfType(type);
        const more = loose > 0 ? ` (${detail.loose(loose)})` : "";
        return (
          <li key={type} class="chip" style={category ? hue(category) : {}}>
            {blockName(type, language.value)} <b>{count}</b>
            {more}
          </li>
        );
      })}
    </ul>
  );
}

const hue = (category: Category) => ({ "--hue": CATEGORY_COLOURS[category] });
