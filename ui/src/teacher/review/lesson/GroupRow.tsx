import { ChevronDown } from "lucide-preact";
import { useMemo } from "preact/hooks";
import { TEST } from "../app/testids";
import { words } from "../i18n/review";
import { GroupPicture } from "../screens/GroupPicture";
import { CategoryChips } from "./BlockChips";
import { FigureRow } from "./FigureRow";
import { GroupDetail } from "./GroupDetail";
import { Line } from "./Line";
import type { LineLayout } from "./line_layout";
import { MarkBook } from "./mark_words";
import type { GroupReview } from "./model";

interface GroupRowProps {
  review: GroupReview;
  layout: LineLayout;
  /** The lesson went on over several days. */
  withDays: boolean;
  open: boolean;
  onToggle(): void;
}

/** One group: who, its line, what was counted; its runs in words when it is opened. */
export function GroupRow({ review, layout, withDays, open, onToggle }: GroupRowProps) {
  const { group, marks, figures, blocks } = review;
  const { lesson, detail } = words.value;
  const book = useMemo(() => new MarkBook(marks, withDays), [marks, withDays]);
  return (
    <li
      class="group-row tinted"
      style={{ "--group": group.color }}
      data-testid={TEST.reviewGroup}
      data-name={group.name}
    >
      <div class="group-row__who">
        <button
          type="button"
          class="group-row__name"
          aria-expanded={open}
          title={`${group.name}. ${open ? detail.close(group.name) : detail.open(group.name)}`}
          data-testid={TEST.reviewOpen}
          onClick={onToggle}
        >
          <GroupPicture name={group.picture} class="group-row__picture" />
          <span dir="auto">{group.name}</span>
          <ChevronDown class="icon group-row__chevron" aria-hidden="true" />
        </button>
        <CategoryChips blocks={blocks} />
      </div>
      <div class="group-row__work">
        {marks.length === 0 ? (
          <p class="group-row__nothing">{lesson.nothing}</p>
        ) : (
          <div class="group-row__line">
            <Line group={group.name} book={book} layout={layout} />
          </div>
        )}
        <FigureRow group={group.name} figures={figures} />
      </div>
      {open && <GroupDetail review={review} book={book} />}
    </li>
  );
}
