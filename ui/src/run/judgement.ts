import type { Activity, CheckProgress, CheckStatusChangedEvent, JudgedEvent } from "../api/model";
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
  if (judged.passed) return { text: activity.passed, detail: ended.text, tone: "done" };
  // a failed run keeps its reason and advice; the mission's card shows that it is not judged
  if (judged.not_judged)
    return ended.tone === "fault" ? ended : { ...ended, detail: judged.not_judged };
  // for a run that PINEL lost, `missing` is the same sentence as the ending, which already has advice
  if (judged.missing?.startsWith(ended.text)) return ended;
  const tone = ended.tone === "done" ? "notice" : ended.tone;
  // blocks that did not run come first: what the rest of the program lacks may be just them
  const what = ended.idle ?? judged.missing;
  if (what) return { ...ended, tone, detail: activity.missing({ what }) };
  return { ...ended, tone, detail: activity.toTheEnd };
}

/** The check list of an activity: as evaluated in `run`, during and after it; else with all checks open. */
export function checksOf(
  { checks }: Pick<Activity, "checks">,
  run: string | null,
  checkStatus: CheckStatusChangedEvent | null,
): readonly CheckProgress[] {
  if (run !== null && checkStatus?.run === run) return checkStatus.checks;
  return checks.map((criterion) => ({ criterion, measured: "", state: "open" }));
}

/** The verdict on a run, if there is one. */
export function verdictOf(run: string | null, judged: JudgedEvent | null): JudgedEvent | null {
  return run !== null && judged?.run === run ? judged : null;
}
