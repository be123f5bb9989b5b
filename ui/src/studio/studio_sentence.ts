import { texts } from "../i18n";
import { duration } from "../i18n/format";
import { inspectedTick, shown } from "../run/inspected_tick";
import * as robot from "../run/live";
import { SIMULATOR } from "../run/real/real_robot";
import { type Sentence, type SentenceContext, sentenceOf } from "../run/sentence";
import { connection, engine } from "../shell/session";
import type { OpenProgram } from "./program/open_program";
import type { WorldControl } from "./world_control";

export const calm = (text: string): Sentence => ({ text, detail: "", tone: "calm" });
const notice = (text: string): Sentence => ({ text, detail: "", tone: "notice" });

/** What the program lacks before it can run; null if it lacks nothing. `asked`: Run was pressed all the same. */
export function beforeRunSentence(
  open: OpenProgram,
  worlds: WorldControl,
  asked: boolean,
): Sentence | null {
  const { status, trouble, world } = texts.value;
  if (open.autosave.state.value === "failed") return notice(status.unsaved);
  const { value: deleted } = open.deleted;
  if (deleted) return notice(trouble.deleted[deleted]);
  const faults = open.faults.value.length;
  if (faults > 0) return notice(status.faults({ count: faults }));
  if (worlds.isFaulty.value) return notice(world.faulty);
  if (!open.isEmpty) return null;
  return asked ? notice(status.emptyRun) : calm(status.empty);
}

/** What of PINEL is not there; null if all is. */
export function serverSentence(): Sentence | null {
  const { status, trouble } = texts.value;
  if (connection.value === "gone") return calm(trouble.goneTitle);
  const isLost = connection.value === "open" && engine.value === "lost";
  return isLost ? notice(status.engineLost) : null;
}

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
