import type { JudgedEvent } from "../api/model";
import type { Texts } from "../i18n";
import type { Sentence } from "./sentence";

/** The sentence at the end of a run, with the result of the lesson's activity. */
export function withJudgement(
  ended: Sentence,
  run: string | null,
  judged: JudgedEvent | null,
  { activity }: Texts,
): Sentence {
  if (!judged || judged.run !== run) return ended;
  if (judged.passed) return { text: activity.passed, more: ended.text, tone: "done" };
  const tone = ended.tone === "done" ? "notice" : ended.tone;
  if (judged.missing) return { ...ended, tone, more: activity.missing(judged.missing) };
  return { ...ended, tone, more: activity.toTheEnd };
}
