import { Play } from "lucide-preact";
import type { GroupReview, LessonReview } from "../../../api/model";
import { language, texts } from "../../../i18n";
import { Button } from "../../../kit/Button";
import { LinkButton } from "../../../kit/LinkButton";
import { hashOf } from "../../../shell/route";
import { rowOf } from "./GroupRow";
import type { LessonViewState } from "./lesson_view_state";

interface LessonSummaryProps {
  review: LessonReview;
  viewState: LessonViewState;
}

/** Shows which groups need help first; groups are not ranked. */
export function LessonSummary({ review: { summary, groups }, viewState }: LessonSummaryProps) {
  const labels = texts.value.review.lesson;
  const { n_passed, n_groups, fault, fault_run, n_with_fault, not_begun, differing } = summary;
  const stuck = groups.filter(({ need }) => need === "help");
  const unconfirmed = unconfirmedTexts(groups);
  const n_other = unconfirmed.length + stuck.length + not_begun.length + differing.length;
  if (n_passed === null && !fault && n_other === 0) return null;
  return (
    <ul class="lesson__summary" aria-label={labels.summary} data-testid="lesson-summary">
      {n_passed !== null && n_groups > 0 && (
        <li class="lesson__passed">{labels.passedBy({ n: n_passed, all: n_groups })}</li>
      )}
      {unconfirmed.map((text) => (
        <li key={text}>{text}</li>
      ))}
      {stuck.length > 0 && (
        <li class="lesson__stuck">
          <span>{labels.stuck}</span>
          {stuck.map((one) => (
            <StuckGroup key={one.group.id} review={one} viewState={viewState} />
          ))}
        </li>
      )}
      {differing.length > 0 && <li>{labels.differing({ activities: inList(differing) })}</li>}
      {not_begun.length > 0 && <li>{labels.notBegun({ names: inList(not_begun) })}</li>}
      {fault && (
        <li class="lesson__fault">
          <span>{labels.commonFault({ count: n_with_fault, what: fault })}</span>
          {fault_run && (
            <LinkButton icon={Play} href={hashOf({ screen: "replay", run: fault_run })}>
              {texts.value.review.detail.replay}
            </LinkButton>
          )}
        </li>
      )}
    </ul>
  );
}

/** Texts about merged runs that await re-verification or that differed from their file. */
function unconfirmedTexts(groups: readonly GroupReview[]): string[] {
  const { unconfirmed: labels } = texts.value.exchange;
  const found = groups.flatMap(({ entries }) => entries.map(({ unconfirmed }) => unconfirmed));
  const waiting = found.filter((one) => one === "waiting").length;
  const wrong = found.filter((one) => one === "differs" || one === "not_passed").length;
  const notRepeatable = found.filter((one) => one === "not_repeatable").length;
  return [
    waiting > 0 ? labels.waiting({ count: waiting }) : "",
    wrong > 0 ? labels.wrong({ count: wrong }) : "",
    notRepeatable > 0 ? labels.notRepeatable({ count: notRepeatable }) : "",
  ].filter(Boolean);
}

interface StuckGroupProps {
  review: GroupReview;
  viewState: LessonViewState;
}

/** The name of a group that needs help; shows its runs. */
function StuckGroup({ review: { group }, viewState: { open } }: StuckGroupProps) {
  const show = () => {
    open.value = new Set([...open.value, group.id]);
    rowOf(group.id)?.querySelector("button")?.focus();
  };
  return (
    <Button
      class="tinted"
      style={{ "--group": group.color }}
      tip={texts.value.review.detail.open({ group: group.name })}
      testId="lesson-stuck"
      onPress={show}
    >
      {group.name}
    </Button>
  );
}

const inList = (names: readonly string[]) =>
  new Intl.ListFormat(language.value, { type: "conjunction" }).format(names);
