import { ChevronDown } from "lucide-preact";
import { useMemo } from "preact/hooks";
import type { GroupReview } from "../../../api/model";
import { texts } from "../../../i18n";
import { Button } from "../../../kit/Button";
import { GroupPicture } from "../../../kit/pictures/GroupPicture";
import { GroupTimeline } from "../timeline/GroupTimeline";
import type { TimelineLayout } from "../timeline/timeline_layout";
import { TimelineIndex } from "../timeline_entries/timeline_texts";
import { CategoryChips } from "./CategoryChips";
import { GroupDetail } from "./GroupDetail";
import { MetricRow } from "./MetricRow";

interface GroupRowProps {
  review: GroupReview;
  layout: TimelineLayout;
  /** Whether the lesson lasted several days. */
  withDays: boolean;
  /** PCs of the group if another one looks like it, else "". */
  lookalikeOn: string;
  open: boolean;
  onToggle(): void;
  onAccepted(): unknown;
}

/** The element of a group's row, if it is shown. */
export const rowOf = (group: string) => document.getElementById(`group-${group}`);

/** A group: its name, what it is at and its timeline; when opened and on paper its metrics, when opened its runs as text. */
export function GroupRow(props: GroupRowProps) {
  const { review, layout, withDays, lookalikeOn, open, onToggle, onAccepted } = props;
  const { group, entries, figures, blocks, hints } = review;
  const { lesson, detail } = texts.value.review;
  const book = useMemo(() => new TimelineIndex(entries, withDays), [entries, withDays]);
  return (
    <li
      id={`group-${group.id}`}
      class="group-row tinted"
      style={{ "--group": group.color }}
      data-testid="review-group"
      data-name={group.name}
      data-need={review.need}
      data-open={open}
    >
      <div class="group-row__who">
        <Button
          kind="bare"
          class="group-row__name row middle gap-2"
          open={open}
          tip={`${group.name}. ${open ? detail.close({ group: group.name }) : detail.open({ group: group.name })}`}
          testId="review-open"
          onPress={onToggle}
        >
          <GroupPicture name={group.picture} class="group-row__picture" />
          <span dir="auto">{group.name}</span>
          <ChevronDown class="icon group-row__chevron" aria-hidden="true" />
        </Button>
        {lookalikeOn && <p class="group-row__computer one-line aside">{lookalikeOn}</p>}
        <CategoryChips blocks={blocks} />
      </div>
      <div class="group-row__work">
        <p class="group-row__sentence" data-testid="review-sentence">
          {review.sentence}
        </p>
        {entries.length === 0 ? (
          <p class="group-row__nothing">{lesson.nothing}</p>
        ) : (
          <div class="group-row__line">
            <GroupTimeline group={group.name} book={book} layout={layout} />
          </div>
        )}
        <MetricRow group={group.name} metrics={figures} hints={hints} />
      </div>
      {open && <GroupDetail review={review} book={book} onAccepted={onAccepted} />}
    </li>
  );
}
