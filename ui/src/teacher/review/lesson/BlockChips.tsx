import type { BlockCount } from "../../../api/model";
import { language, texts } from "../../../i18n";
import { categoryOfType, hueOf } from "../timeline_entries/block_kinds";
import { blockName } from "../timeline_entries/difference_texts";

interface BlockChipsProps {
  blocks: readonly BlockCount[];
}

/** Each type of block in use, with its text. */
export function BlockChips({ blocks }: BlockChipsProps) {
  const { detail } = texts.value.review;
  if (blocks.length === 0) return <p class="detail__none">{detail.noBlocks}</p>;
  return (
    <ul class="chips row wrap gap-1">
      {blocks.map(({ type, count, loose }) => {
        const category = categoryOfType(type);
        const more = loose > 0 ? ` (${detail.loose({ count: loose })})` : "";
        return (
          <li key={type} class="chip" style={category ? hueOf(category) : {}}>
            {blockName(type, language.value)} <b>{count}</b>
            {more}
          </li>
        );
      })}
    </ul>
  );
}
