import type { GroupReview } from "../../../api/model";
import { texts } from "../../../i18n";
import { PresentButton } from "../../../shell/projector/PresentButton";
import type { TimelineIndex } from "../timeline_entries/timeline_texts";
import { BlockChips } from "./BlockChips";
import { HintsRead } from "./HintsRead";
import { RunRow } from "./RunRow";

interface GroupDetailProps {
  review: GroupReview;
  book: TimelineIndex;
  onAccepted(): unknown;
}

/** The runs of a group as text, and the blocks that it used. */
export function GroupDetail({ review, book, onAccepted }: GroupDetailProps) {
  const { detail } = texts.value.review;
  const program = review.entries.findLast(({ program_id }) => program_id)?.program_id;
  const runs = review.entries.filter(({ kind }) => kind === "run");
  return (
    <div class="detail" data-testid="review-detail">
      <div>
        <h2 class="detail__title">{detail.runs}</h2>
        {runs.length === 0 && <p class="detail__none">{detail.noRuns}</p>}
        <ol>
          {runs.map((entry) => (
            <RunRow key={entry.run_id} entry={entry} book={book} onAccepted={onAccepted} />
          ))}
        </ol>
      </div>
      <div>
        <HintsRead hints={review.hints} />
        <div class="row middle apart">
          <h2 class="detail__title">{detail.blocks}</h2>
          {program && <PresentButton program={program} />}
        </div>
        <BlockChips blocks={review.blocks} />
      </div>
    </div>
  );
}
