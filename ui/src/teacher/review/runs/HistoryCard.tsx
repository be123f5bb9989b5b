import type { Signal } from "@preact/signals";
import type { HistoryRun } from "../../../api/model";
import { language, texts } from "../../../i18n";
import { duration, relativeDateAndTime } from "../../../i18n/format";
import { GroupPicture } from "../../../kit/pictures/GroupPicture";
import { RobotName } from "../../../run/real/RobotName";
import { PathPicture } from "../../../scene/small/PathPicture";
import { hashOf } from "../../../shell/route";
import { worldLabel } from "../../../versions/setup_texts";
import { outcomeOf, type RunOutcome } from "../model";
import { OutcomeIcon } from "../OutcomeIcon";
import { UnusualLine } from "../UnusualLine";

/** Outcomes with a shorter text on cards. */
const SHORT: Partial<
  Record<RunOutcome, "passed" | "not_passed" | "finished" | "stopped" | "failed">
> = {
  passed: "passed",
  notyet: "not_passed",
  finished: "finished",
  stopped: "stopped",
  failed: "failed",
};

interface HistoryCardProps {
  run: HistoryRun;
  chosen: Signal<readonly HistoryRun[]>;
  /** Title of the run's lesson; null without a lesson and before the lessons are loaded. */
  lesson: string | null;
}

/** A run with its group: links to its replay, and can be selected for comparison. */
export function HistoryCard({ run, chosen, lesson }: HistoryCardProps) {
  const { outcomes, runs } = texts.value.review;
  const { work } = texts.value;
  const outcome = outcomeOf(run);
  const name = run.program_name ?? work.noName;
  const facts = [
    relativeDateAndTime(run.started_at, new Date(), language.value, texts.value),
    run.duration_s === null ? null : duration(run.duration_s, language.value),
  ].filter(Boolean);
  const place = [worldLabel(run.world, texts.value, language.value), lesson]
    .filter(Boolean)
    .join(" · ");
  const title = `${run.group?.name ?? runs.commandLine}, ${name}, ${outcomes[outcome]}`;
  return (
    <div
      class="work-card card tinted run-card"
      style={run.group ? { "--group": run.group.color } : {}}
      data-testid="history-run"
      data-outcome={outcome}
    >
      <a class="run-card__open" href={hashOf({ screen: "replay", run: run.id })}>
        <span class="work-card__picture">
          <PathPicture path={run.path} failed={run.state === "failed"} />
        </span>
        <span class="work-card__words">
          <span class="run-card__group row middle gap-2">
            <GroupPicture name={run.group?.picture ?? ""} class="run-card__picture" />
            <span data-shortened title={run.group?.name}>
              {run.group?.name ?? runs.commandLine}
            </span>
          </span>
          <RobotName link={run.link} calibrated={run.calibrated_robot} />
          <span class="work-card__line work-card__line--strong run-card__outcome">
            <OutcomeIcon outcome={outcome} />
            {SHORT[outcome] ? runs.outcomes[SHORT[outcome]] : outcomes[outcome]}
          </span>
          {run.unconfirmed && (
            <span class="work-card__line">
              {texts.value.review.detail.unconfirmed[run.unconfirmed]}
            </span>
          )}
          <span class="work-card__line">{name}</span>
          <UnusualLine run={run.id} isShort />
          <span
            class="work-card__line run-card__place"
            title={place}
            data-testid="history-place"
            data-shortened
          >
            {place}
          </span>
          <span class="work-card__line work-card__line--facts">{facts.join(" · ")}</span>
        </span>
      </a>
      <Choose run={run} chosen={chosen} title={title} />
    </div>
  );
}

function Choose({ run, chosen, title }: Omit<HistoryCardProps, "lesson"> & { title: string }) {
  const { runs } = texts.value.review;
  const isChosen = chosen.value.some(({ id }) => id === run.id);
  return (
    <label class="run-card__choose aside row middle gap-2" data-chosen={isChosen}>
      <input
        type="checkbox"
        checked={isChosen}
        disabled={run.state === "running"}
        aria-label={runs.chooseOf({ run: title })}
        data-testid="compare-choose"
        onChange={() => {
          const others = chosen.value.filter(({ id }) => id !== run.id);
          // a third selection replaces the first
          chosen.value = isChosen ? others : [...others.slice(-1), run];
        }}
      />
      <span>{isChosen ? runs.chosen : runs.choose}</span>
    </label>
  );
}
