import { GitCompareArrows, Play } from "lucide-preact";
import type { TimelineEntry } from "../../../api/model";
import { reviewApi } from "../../../api/review";
import { texts } from "../../../i18n";
import { Button } from "../../../kit/Button";
import { LinkButton } from "../../../kit/LinkButton";
import { useAction } from "../../../kit/requests/action";
import { FaultLine } from "../../../kit/requests/FaultLine";
import { Loaded } from "../../../kit/requests/Loaded";
import { useLoaded } from "../../../kit/requests/useLoaded";
import { PresentButton } from "../../../shell/projector/PresentButton";
import { hashOf } from "../../../shell/route";
import { asTeacher } from "../../../shell/teacher/teacher_session";
import { TruthLines } from "../../../truth/TruthLines";
import { outcomeOf } from "../model";
import { OutcomeIcon } from "../OutcomeIcon";
import {
  changeTexts,
  facts,
  runTitle,
  type TimelineIndex,
} from "../timeline_entries/timeline_texts";
import { differenceOf } from "../timeline_entries/version_differences";
import { UnusualLine } from "../UnusualLine";

interface RunRowProps {
  entry: TimelineEntry;
  book: TimelineIndex;
  /** Called after the teacher has accepted the run. */
  onAccepted(): unknown;
}

/** A run as text: outcome, changes that repaired another run, notes, and links to its views. */
export function RunRow({ entry, book, onAccepted }: RunRowProps) {
  const { detail } = texts.value.review;
  const outcome = outcomeOf(entry);
  if (!entry.run_id) return null;
  return (
    <li class="run-line row top gap-3" data-testid="review-run" data-outcome={outcome}>
      <OutcomeIcon outcome={outcome} />
      <div class="run-line__words">
        <p>
          <b>{runTitle(entry, book)}</b> <span class="run-line__facts">{facts(entry, book)}</span>
        </p>
        {entry.unconfirmed && <p>{detail.unconfirmed[entry.unconfirmed]}</p>}
        {entry.message && outcome !== "stopped" && <p>{entry.message}</p>}
        <UnusualLine run={entry.run_id} />
        <Repair entry={entry} book={book} />
        <TruthLines run={entry.run_id} link={entry.link} />
        <Notes run={entry.run_id} />
      </div>
      <div class="run-line__links row rigid gap-2">
        {entry.unconfirmed === "not_repeatable" && (
          <Accept run={entry.run_id} title={runTitle(entry, book)} onAccepted={onAccepted} />
        )}
        {entry.repairs && (
          <LinkButton
            icon={GitCompareArrows}
            label={detail.compare({ n: book.numberOf(entry.repairs) })}
            href={hashOf({ screen: "compare", first: entry.repairs, second: entry.run_id })}
          />
        )}
        <LinkButton icon={Play} href={hashOf({ screen: "replay", run: entry.run_id })}>
          {detail.replay}
        </LinkButton>
        <PresentButton first={entry.run_id} />
      </div>
    </li>
  );
}

interface AcceptProps {
  run: string;
  title: string;
  onAccepted(): unknown;
}

/** Button by which the teacher accepts a run that this PC cannot repeat. */
function Accept({ run, title, onAccepted }: AcceptProps) {
  const { busy, fault, act } = useAction(asTeacher);
  const { detail } = texts.value.review;
  const accept = () => act(async () => reviewApi.accept(run).then(onAccepted));
  return (
    <>
      <Button
        busy={busy}
        testId="accept-run"
        label={detail.acceptOf({ run: title })}
        onPress={accept}
      >
        {detail.accept}
      </Button>
      <FaultLine fault={fault} />
    </>
  );
}

/** Changes between the failed run and this one. */
function Repair({ entry, book }: Omit<RunRowProps, "onAccepted">) {
  const { line } = texts.value.review;
  if (!entry.repairs) return null;
  const changes = changeTexts(entry, differenceOf(entry));
  return (
    <p class="run-line__repair" data-testid="review-repair">
      {line.repairs({ n: book.numberOf(entry.repairs) })}{" "}
      {changes.length > 0 && `${line.between} ${changes.join("; ")}.`}
    </p>
  );
}

function Notes({ run }: { run: string }) {
  const notes = useLoaded(run, () => reviewApi.notes(run));
  return (
    <Loaded of={notes}>
      {(found) =>
        found.map((note) => (
          <p key={note.id} class="run-line__note">
            <b>{texts.value.review.detail.note}:</b> {note.text}
          </p>
        ))
      }
    </Loaded>
  );
}
