import { useSignal } from "@preact/signals";
import { GitCompareArrows, Play } from "lucide-preact";
import { useEffect } from "preact/hooks";
import type { Note } from "../api/model";
import { reviewApi } from "../api/review";
import { hashOf } from "../app/route";
import { report } from "../app/session";
import { TEST } from "../app/testids";
import { language, texts } from "../i18n";
import { words } from "../i18n/review";
import { BlockChips } from "./BlockChips";
import { differenceOf } from "./differences";
import { changesInWords, facts, type MarkBook } from "./mark_words";
import { type GroupReview, outcomeOf, type ReviewMark } from "./model";
import { Sign } from "./Sign";

interface GroupDetailProps {
  review: GroupReview;
  book: MarkBook;
}

/** The runs of a group in words, what made the failing ones good, notes, and the blocks in use. */
export function GroupDetail({ review, book }: GroupDetailProps) {
  const { detail } = words.value;
  const runs = review.marks.filter(({ kind }) => kind === "run");
  return (
    <div class="detail" data-testid={TEST.reviewDetail}>
      <div class="detail__runs">
        <h2 class="detail__title">{detail.runs}</h2>
        {runs.length === 0 && <p class="detail__none">{detail.noRuns}</p>}
        <ol>
          {runs.map((mark) => (
            <RunLine key={mark.run_id} mark={mark} book={book} />
          ))}
        </ol>
      </div>
      <div class="detail__blocks">
        <h2 class="detail__title">{detail.blocks}</h2>
        <BlockChips blocks={review.blocks} />
      </div>
    </div>
  );
}

function RunLine({ mark, book }: { mark: ReviewMark; book: MarkBook }) {
  const { line, outcomes, detail } = words.value;
  const outcome = outcomeOf(mark);
  const speech = { texts: words.value, language: language.value, page: texts.value };
  if (!mark.run_id) return null;
  return (
    <li class="run-line" data-testid={TEST.reviewRun} data-outcome={outcome}>
      <Sign outcome={outcome} />
      <div class="run-line__words">
        <p>
          <b>
            {line.run(book.numberOf(mark.run_id))}: {outcomes[outcome]}
          </b>{" "}
          <span class="run-line__facts">{facts(mark, book, speech)}</span>
        </p>
        {mark.message && outcome !== "stopped" && <p>{mark.message}</p>}
        <Repair mark={mark} book={book} />
        <Notes run={mark.run_id} />
      </div>
      <div class="run-line__links">
        {mark.repairs && (
          <a
            class="button button--icon"
            href={hashOf({ screen: "compare", runs: [mark.repairs, mark.run_id] })}
            aria-label={detail.compare(book.numberOf(mark.repairs))}
            title={detail.compare(book.numberOf(mark.repairs))}
          >
            <GitCompareArrows class="icon" aria-hidden="true" />
          </a>
        )}
        <a class="button" href={hashOf({ screen: "replay", run: mark.run_id })}>
          <Play class="icon" aria-hidden="true" />
          {detail.replay}
        </a>
      </div>
    </li>
  );
}

/** What was changed between the run that failed and this one. */
function Repair({ mark, book }: { mark: ReviewMark; book: MarkBook }) {
  const { line } = words.value;
  if (!mark.repairs) return null;
  const { since, version_id } = mark;
  const difference = since && version_id ? differenceOf(since, version_id).value : null;
  const speech = { texts: words.value, language: language.value, page: texts.value };
  const changes = changesInWords(mark, difference, speech);
  return (
    <p class="run-line__repair" data-testid={TEST.reviewRepair}>
      {line.repairs(book.numberOf(mark.repairs))}{" "}
      {changes.length > 0 && `${line.between} ${changes.join("; ")}.`}
    </p>
  );
}

function Notes({ run }: { run: string }) {
  const { detail } = words.value;
  const notes = useSignal<readonly Note[]>([]);
  useEffect(() => {
    reviewApi.notes(run).then((found) => {
      notes.value = found;
    }, report);
  }, [run]);
  return (
    <>
      {notes.value.map((note) => (
        <p key={note.id} class="run-line__note">
          <b>{detail.note}:</b> {note.text}
        </p>
      ))}
    </>
  );
}
