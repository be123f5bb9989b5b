import type { Language, Texts } from "../i18n";
import { degrees, formatNumber, metres, seconds } from "../i18n/format";
import { reasonText } from "../i18n/reasons";
import { captureText } from "./captures/captured";
import { drivingText } from "./driving";
import { idleParts, type StoredProgram } from "./idle_parts";
import type { ActiveBlock, Motion, RunView } from "./reducer";
import { localizeNumbers } from "./values";

/** Tone of a sentence, for its colour and icon. */
export type Tone = "calm" | "moving" | "done" | "notice" | "fault";

/** The state of a run in one line: `text`, `detail` with what else is to be said or done, `part` with the progress of the motion. */
export interface Sentence {
  text: string;
  detail: string;
  tone: Tone;
  /** Whether `detail` is written at a block, so that the line only says it to screen readers. */
  isAtBlock?: boolean;
  /** Of a finished run: which blocks did nothing, and why; the first thing to mend. */
  idle?: string;
  part?: number | null;
}

/** Below this distance from the start the path counts as closed. */
const CLOSED_M = 0.01;

/** Ticks for which a message of the robot, or the answer to a capture, stays in the sentence. */
const RECENT_TICKS = 90;

const LOOPS = new Set(["repeat", "while", "until", "for", "forever"]);

/** Endings after which the only advice is to run again. */
const RUN_AGAIN = new Set([
  "stopped_by_person",
  "engine_lost",
  "real_engine_lost",
  "link_lost",
  "internal_error",
]);

export interface SentenceContext {
  texts: Texts;
  language: Language;
  /** Returns a parameter of the command at a JSON pointer of the document, as the document has it. */
  parameterOf(pointer: string, name: string): unknown;
  /** For a recorded run: the text does not mention buttons that only a live run has. */
  past?: boolean;
  /** The program that ran: the sentence at the end names the parts that did nothing. */
  program?: StoredProgram | null;
}

export function sentenceOf(view: RunView, context: SentenceContext): Sentence | null {
  const { status } = context.texts;
  switch (view.phase) {
    case "idle":
      return null;
    case "starting":
      return { text: status.starting, detail: "", tone: "calm" };
    case "paused":
      if (context.past) return { text: context.texts.replay.paused, detail: "", tone: "notice" };
      return view.next === null
        ? { text: status.paused, detail: "", tone: "notice" }
        : { text: status.held, detail: status.heldHow, tone: "notice" };
    case "running":
      return {
        text: doing(view, context),
        detail: around(view, context),
        tone: "moving",
        part: partOf(view.motion),
      };
    default:
      return ending(view, context);
  }
}

function doing(view: RunView, context: SentenceContext): string {
  const { status } = context.texts;
  const current = view.stack.at(-1);
  if (view.output.question) return status.asking;
  if (view.capture) return view.capture.what === "number" ? status.captureNumber : status.capture;
  if (!current) return status.running;
  if (view.motion) return moving(view.motion, context);
  return (
    COMMANDS[current.action]?.(current, view, context) ?? driving(view, context) ?? status.running
  );
}

const COMMANDS: Readonly<
  Record<string, (command: ActiveBlock, view: RunView, context: SentenceContext) => string>
> = {
  stop: (_command, _view, { texts }) => texts.status.stopping,
  set_gesture_result: (_command, { gesture }, { texts }) =>
    gesture ? texts.status.gesture({ sign: gesture }) : texts.status.noGesture,
  go_to: ({ pointer }, _view, { texts, language, parameterOf }) => {
    const [x, y] = [parameterOf(pointer, "x"), parameterOf(pointer, "y")];
    if (typeof x !== "number" || typeof y !== "number") return texts.status.goToSomewhere;
    return texts.status.goTo({ x: metres(x, language), y: metres(y, language) });
  },
  go_to_place: ({ pointer }, _view, { texts, parameterOf }) => {
    const place = parameterOf(pointer, "place");
    return typeof place === "string"
      ? texts.status.goToPlace({ name: place })
      : texts.status.goToSomePlace;
  },
  wait_until: ({ pointer }, _view, { texts, language, parameterOf }) => {
    const timeout = parameterOf(pointer, "timeout");
    if (typeof timeout !== "number") return texts.status.waitUntil;
    return texts.status.waitUntilAtMost({ timeout: seconds(timeout, language) });
  },
};

function moving(motion: Motion, { texts, language }: SentenceContext): string {
  const { status } = texts;
  const show = (format: (value: number, language: Language) => string) => ({
    done: format(Math.abs(motion.done), language),
    amount: format(Math.abs(motion.amount), language),
  });
  switch (motion.kind) {
    case "move_forward":
      return status.forward(show(metres));
    case "move_backward":
      return status.backward(show(metres));
    case "turn":
      return motion.amount < 0 ? status.right(show(degrees)) : status.left(show(degrees));
    case "arc":
      return motion.amount < 0 ? status.arcRight(show(degrees)) : status.arcLeft(show(degrees));
    case "wait":
      return status.wait(show(seconds));
    default:
      return status.running;
  }
}

function driving(view: RunView, { texts, language }: SentenceContext): string | null {
  return drivingText(view.speed, texts, language);
}

function partOf(motion: Motion | null): number | null {
  if (!motion || motion.amount === 0) return null;
  return Math.min(1, Math.max(0, motion.done / motion.amount));
}

/**
 * Context of the command: a recent message or answer to a capture, else the loop round, the
 * function, and whether the robot is moving.
 */
function around(view: RunView, context: SentenceContext): string {
  const { status } = context.texts;
  const message = view.output.talk.findLast((line) => line.kind === "said");
  // robot time stops during a capture: messages before and after it may have the same tick
  const isNewerThanCapture = message && message.number >= (view.captured?.nextLine ?? 0);
  const answer = isNewerThanCapture ? "" : answered(view, context);
  if (answer) return answer;
  const isRecent = message && view.tick - message.tick < RECENT_TICKS;
  const sounds = [
    isRecent ? status.says({ text: localizeNumbers(String(message.text), context.language) }) : "",
    beeped(view, context),
  ];
  if (sounds.some(Boolean)) return sounds.filter(Boolean).join(" · ");
  const call = view.output.calls.at(-1);
  const isWaiting = view.motion?.kind === "wait" || view.stack.at(-1)?.action === "wait_until";
  return [
    isWaiting ? driving(view, context) : null,
    round(view, context),
    call ? status.inFunction({ name: call.function }) : null,
  ]
    .filter(Boolean)
    .join(" · ");
}

/** Text of the consecutive beeps; "" if the newest is older than `RECENT_TICKS`. */
function beeped({ output: { beeps }, tick }: RunView, { texts }: SentenceContext): string {
  const isRecent = beeps.count > 0 && tick - beeps.tick < RECENT_TICKS;
  return isRecent ? texts.show.beeps({ count: beeps.inRow }) : "";
}

/** Text of the answer to a capture; "" if it is older than `RECENT_TICKS`. */
function answered({ captured, tick }: RunView, { texts, language }: SentenceContext): string {
  const isRecent = captured && tick - captured.tick < RECENT_TICKS;
  return isRecent ? captureText(captured, texts, language) : "";
}

function round(view: RunView, { texts, language, parameterOf }: SentenceContext): string {
  const loop = view.stack.findLast((entry) => LOOPS.has(entry.action));
  if (!loop?.round) return "";
  const times = loop.action === "repeat" ? parameterOf(loop.pointer, "times") : null;
  if (typeof times !== "number") return texts.status.roundOnly({ round: loop.round });
  return texts.status.round({ round: loop.round, times: formatNumber(times, language) });
}

function ending(view: RunView, context: SentenceContext): Sentence {
  const { texts, language, past } = context;
  const { reason = null, params = {} } = view.ending ?? {};
  const explanation = reasonText(reason, params, language);
  if (view.phase === "failed" || view.phase === "stopped") {
    const detail = past && RUN_AGAIN.has(reason ?? "") ? "" : explanation?.remedy;
    const tone = view.phase === "failed" ? "fault" : "notice";
    return { text: explanation?.message ?? texts.status.failed, detail: detail ?? "", tone };
  }
  return finishedSentence(view, context);
}

/**
 * The sentence of a run that ended without a fault. A remark about a likely oversight of the
 * pupils has the tone `notice`, not `done`.
 */
function finishedSentence(view: RunView, context: SentenceContext): Sentence {
  const { status } = context.texts;
  const { emptyLoops, looseBlocks, hasMotion } = idleParts(context.program ?? NO_PROGRAM);
  const isStill = !view.moved && (hasMotion || !showedSomething(view));
  const remarks = [
    emptyLoops > 0 && status.emptyLoop({ count: emptyLoops }),
    looseBlocks > 0 && status.looseBlocks({ count: looseBlocks }),
  ].filter((remark) => remark !== false);
  const text = isStill ? status.finishedStill : finished(view, context.texts, context.language);
  const estimate = isStill ? "" : estimated(view, context);
  const idle = remarks.join(" ");
  const detail = [idle, estimate, answered(view, context)].filter(Boolean).join(" ");
  const tone = isStill || idle ? "notice" : "done";
  return idle ? { text, detail, tone, idle } : { text, detail, tone };
}

const NO_PROGRAM: StoredProgram = { document: null, workspace: null };

function showedSomething({ output, captured }: RunView): boolean {
  return output.talk.length > 0 || output.marks.length > 0 || captured !== null;
}

function finished(view: RunView, { status }: Texts, language: Language): string {
  const { pathLengthM, closingErrorM } = view.ending ?? {};
  if (!pathLengthM || closingErrorM == null || pathLengthM < CLOSED_M) return status.finished;
  if (closingErrorM < CLOSED_M) return status.finishedClosed;
  return status.finishedAway({ distance: metres(closingErrorM, language) });
}

/**
 * The robot's estimated distance from its start. For a simulated robot, "" unless the estimated
 * and the true distance differ by `CLOSED_M` or more.
 */
function estimated(view: RunView, { texts: { status }, language }: SentenceContext): string {
  const { pathLengthM, closingErrorM = null, estimatedClosingErrorM: m } = view.ending ?? {};
  if (!pathLengthM || m == null || pathLengthM < CLOSED_M) return "";
  const [isClosed, distance] = [m < CLOSED_M, metres(m, language)];
  if (closingErrorM === null) {
    return isClosed ? status.measuredClosed : status.measuredAway({ distance });
  }
  if (Math.abs(closingErrorM - m) < CLOSED_M) return "";
  return isClosed ? status.believesClosed : status.believesAway({ distance });
}

/** Returns a parameter of a command of the document. */
export function parameterIn(document: unknown, pointer: string, name: string): unknown {
  // a bare list of commands is a valid program too
  let place: unknown = Array.isArray(document) ? { commands: document } : document;
  for (const key of pointer.split("/").slice(1)) {
    place = (place as Record<string, unknown> | undefined)?.[key];
  }
  return (place as Record<string, unknown> | undefined)?.[name];
}
