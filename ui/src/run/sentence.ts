import type { Language, Texts } from "../i18n";
import { degrees, metres, seconds } from "../i18n/format";
import { reasonWords } from "../i18n/reasons";
import type { LitBlock, Motion, RunView } from "./reducer";

export type Tone = "calm" | "moving" | "done" | "notice" | "fault";

/** What is said of a run in one line: `text`, `more` for what to do about it, `part` of the motion done. */
export interface Sentence {
  text: string;
  more: string;
  tone: Tone;
  part?: number | null;
}

/** Nearer to the start than this counts as having come back. */
const CLOSED_M = 0.01;

interface Voice {
  texts: Texts;
  language: Language;
  /** How often a loop goes round, by its pointer in the document; null where nobody knows. */
  timesOf(pointer: string): number | null;
}

export function sentenceOf(view: RunView, voice: Voice): Sentence | null {
  const { status } = voice.texts;
  switch (view.phase) {
    case "idle":
      return null;
    case "starting":
      return { text: status.starting, more: "", tone: "calm" };
    case "paused":
      return { text: status.paused, more: "", tone: "notice" };
    case "running":
      return {
        text: doing(view, voice),
        more: round(view, voice),
        tone: "moving",
        part: partOf(view.motion),
      };
    default:
      return ending(view, voice);
  }
}

function doing(view: RunView, { texts, language }: Voice): string {
  const { status } = texts;
  const current = view.stack.at(-1);
  if (view.capture) return status.capture;
  if (!current) return status.running;
  if (view.motion) return moving(view.motion, texts, language);
  switch (current.action) {
    case "stop":
      return status.stopping;
    case "set_gesture_result":
      return view.gesture ? status.gesture(view.gesture) : status.noGesture;
    default:
      return status.running;
  }
}

function moving(motion: Motion, texts: Texts, language: Language): string {
  const { status } = texts;
  const show = (format: (value: number, language: Language) => string) =>
    [format(Math.abs(motion.done), language), format(Math.abs(motion.amount), language)] as const;
  switch (motion.kind) {
    case "move_forward":
      return status.forward(...show(metres));
    case "move_backward":
      return status.backward(...show(metres));
    case "turn":
      return motion.amount < 0 ? status.right(...show(degrees)) : status.left(...show(degrees));
    case "wait":
      return status.wait(...show(seconds));
    default:
      return status.running;
  }
}

function partOf(motion: Motion | null): number | null {
  if (!motion || motion.amount === 0) return null;
  return Math.min(1, Math.max(0, motion.done / motion.amount));
}

function round(view: RunView, { texts, timesOf }: Voice): string {
  const loop = view.stack.findLast((entry: LitBlock) => entry.action === "repeat");
  if (!loop || loop.round === 0) return "";
  const times = timesOf(loop.pointer);
  return times === null ? "" : texts.status.round(loop.round, String(times));
}

function ending(view: RunView, { texts, language }: Voice): Sentence {
  const { status } = texts;
  const words = reasonWords(view.ending?.reason ?? null, view.ending?.params ?? {}, language);
  if (view.phase === "failed") {
    return { text: words?.message ?? status.failed, more: words?.remedy ?? "", tone: "fault" };
  }
  if (view.phase === "stopped") {
    return { text: words?.message ?? status.failed, more: words?.remedy ?? "", tone: "notice" };
  }
  return { text: finished(view, texts, language), more: "", tone: "done" };
}

function finished(view: RunView, { status }: Texts, language: Language): string {
  const { pathLengthM, closingErrorM } = view.ending ?? {};
  if (!pathLengthM || closingErrorM == null || pathLengthM < CLOSED_M) return status.finished;
  if (closingErrorM < CLOSED_M) return status.finishedClosed;
  return status.finishedAway(metres(closingErrorM, language));
}

/** Reads how often a loop goes round out of the document. */
export function timesIn(document: unknown, pointer: string): number | null {
  let place: unknown = document;
  for (const key of pointer.split("/").slice(1)) {
    place = (place as Record<string, unknown> | undefined)?.[key];
  }
  const times = (place as { times?: unknown } | undefined)?.times;
  return typeof times === "number" ? times : null;
}
