import type { Activity, CheckLine, ChecksStandEvent, JudgedEvent } from "../api/model";
import type { Texts } from "../i18n";
import type { Sentence } from "./sentence";

/** The sentence at the end of a run, with the result of the lesson's activity. */
export function withVerdict(
  ended: Sentence,
  run: string | null,
  judged: JudgedEvent | null,
  { activity }: Texts,
): Sentence {
  if (!judged || judged.run !== run) return ended;
  if (judged.passed) return { text: activity.passed, more: ended.text, tone: "done" };
  // why a run failed comes with what to do about it; that it is not judged stands on the mission's card
  if (judged.not_judged)
    return ended.tone === "fault" ? ended : { ...ended, more: judged.not_judged };
  // a run that PINEL lost: what is missing is that it ended so, and what to do stands there already
  if (judged.missing?.startsWith(ended.text)) return ended;
  const tone = ended.tone === "done" ? "notice" : ended.tone;
  if (judged.missing) return { ...ended, tone, more: activity.missing(judged.missing) };
  return { ...ended, tone, more: activity.toTheEnd };
}

/** The check list of an activity: of the run, while it goes on and afterwards, else before any run. */
export function checksOf(
  { checks }: Pick<Activity, "checks">,
  run: string | null,
  checkStatus: ChecksStandEvent | null,
): readonly CheckLine[] {
  if (run !== null && checkStatus?.run === run) return checkStatus.checks;
  return checks.map((criterion) => ({ criterion, measured: "", state: "open" }));
}

/** The verdict on a run, if there is one. */
export function verdictOf(run: string | null, judged: JudgedEvent | null): JudgedEvent | null {
  return run !== null && judged?.run === run ? judged : null;
}
