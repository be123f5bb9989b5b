import { texts } from "../i18n";
import { duration } from "../i18n/format";
import { inspectedTick, shown } from "../run/inspected_tick";
import * as robot from "../run/live";
import { SIMULATOR } from "../run/real/real_robot";
import { type Sentence, type SentenceContext, sentenceOf } from "../run/sentence";

/** Adds advice to return a real robot: it stays where its run ended, but the next run begins at the start. */
export function withReturnAdvice(sentence: Sentence): Sentence {
  const isReal = (robot.liveRun.value?.link ?? SIMULATOR) !== SIMULATOR;
  const { reason } = robot.live.value.ending ?? {};
  const hasMore = sentence.detail && reason !== "stopped_by_person";
  return isReal && !hasMore ? { ...sentence, detail: texts.value.robot.backToStart } : sentence;
}

/** The robot's action at the inspected tick, with its time. */
export function pastSentence(context: SentenceContext): Sentence | null {
  const { tick = 0, history } = inspectedTick.value ?? {};
  const sentence = sentenceOf(shown.value, { ...context, past: true });
  if (!sentence || !history) return sentence;
  const time = (ticks: number) => duration(ticks / 30, context.language);
  const at = context.texts.replay.at({ now: time(tick), end: time(history.lastTick) });
  return { ...sentence, detail: [at, sentence.detail].filter(Boolean).join(" · ") };
}
