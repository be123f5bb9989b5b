import type { RunEvent } from "../api/model";
import { EMPTY_TRAIL, extend, lastPoint, type Point, type Trail } from "./trail";

/** A line of the dialogue between the program and the group. */
export interface DialogueLine {
  readonly kind: "said" | "asked" | "answered" | "beeped";
  /** A number if the group's answer can be read as one; for beeps, the number of consecutive beeps. */
  readonly text: string | number;
  readonly block: string | null;
  readonly tick: number;
  /** Index of the line in its run, from 0. */
  readonly number: number;
}

/** A mark on the floor; metres, start frame. */
export interface FloorMark {
  readonly symbol: "X" | "O";
  readonly x: number;
  readonly y: number;
}

/** A pen stroke, from pen down to pen up. */
export interface Stroke {
  readonly color: string;
  readonly trail: Trail;
}

export interface Question {
  readonly block: string | null;
  readonly text: string;
  readonly variable: string;
}

/** An active function call and the block that made it. */
export interface Call {
  readonly function: string;
  readonly block: string | null;
}

/** Counts of the beeps so far. */
export interface Beeps {
  readonly count: number;
  /** Number of consecutive beeps, up to the newest one. */
  readonly inRow: number;
  /** Tick of the newest beep. */
  readonly tick: number;
}

/** All outputs of a program besides motion, with its variables and calls. */
export interface Output {
  /** The newest lines, oldest first. */
  readonly talk: readonly DialogueLine[];
  readonly marks: readonly FloorMark[];
  /** Finished strokes. */
  readonly strokes: readonly Stroke[];
  /** The unfinished stroke; null while the pen is up. */
  readonly pen: Stroke | null;
  /** The pending question, until it is answered or the run goes on without an answer. */
  readonly question: Question | null;
  readonly beeps: Beeps;
  readonly variables: Readonly<Record<string, unknown>>;
  /** The call stack, outermost first. */
  readonly calls: readonly Call[];
}

export const NOTHING: Output = {
  talk: [],
  marks: [],
  strokes: [],
  pen: null,
  question: null,
  beeps: { count: 0, inRow: 0, tick: 0 },
  variables: {},
  calls: [],
};

/** Limits above which the oldest entries are dropped. The states of a run share their entries. */
export const MAX_LINES = 200;
export const MAX_MARKS = 1000;
export const MAX_STROKES = 1000;

/** Longest gap between consecutive beeps, in ticks of the robot; a later beep starts a new row. */
export const ROW_TICKS = 36;

/** The output after an event; the same object when the event changes nothing. `at` is the robot's true position. */
export function reduceOutput(output: Output, event: RunEvent, at: Point): Output {
  switch (event.type) {
    case "telemetry":
      return drawn(output, [event.true_x_m ?? event.x_m, event.true_y_m ?? event.y_m]);
    case "said":
      return { ...output, talk: addLine(output, "said", event.text, event.block, event.tick) };
    case "marked": {
      const mark: FloorMark = { symbol: event.symbol, x: event.x_m, y: event.y_m };
      return { ...output, marks: newest(output.marks, mark, MAX_MARKS) };
    }
    case "beeped":
      return beeped(output, event.block, event.tick);
    case "pen":
      return withPen(output, event.down ? event.color : null, at);
    case "asked": {
      const { block, question, variable, tick } = event;
      const talk = addLine(output, "asked", question, block, tick);
      return { ...output, talk, question: { block, text: question, variable } };
    }
    case "answered": {
      const block = output.question?.block ?? null;
      const talk = addLine(output, "answered", event.value, block, event.tick);
      return { ...output, talk, question: null };
    }
    case "block_ended":
      // nothing else runs while a question is open
      return output.question ? { ...output, question: null } : output;
    case "watch":
      return { ...output, variables: event.variables, calls: event.stack.filter(isNamed) };
    case "run_ended":
      return withPen({ ...output, question: null, calls: [] }, null, at);
    default:
      return output;
  }
}

const isNamed = (call: { function: string | null; block: string | null }): call is Call =>
  call.function !== null;

function addLine(
  { talk }: Output,
  kind: DialogueLine["kind"],
  text: DialogueLine["text"],
  block: string | null,
  tick: number,
): readonly DialogueLine[] {
  const number = (talk.at(-1)?.number ?? -1) + 1;
  return newest(talk, { kind, text, block, tick, number }, MAX_LINES);
}

/** Consecutive beeps share a line of the dialogue, unless the dialogue has another line between them. */
function beeped(output: Output, block: string | null, tick: number): Output {
  const { beeps: before } = output;
  const isNext = before.count > 0 && tick - before.tick <= ROW_TICKS;
  const beeps = { count: before.count + 1, inRow: isNext ? before.inRow + 1 : 1, tick };
  const last = output.talk.at(-1);
  const talk =
    isNext && last?.kind === "beeped"
      ? output.talk.with(-1, { ...last, text: Number(last.text) + 1 })
      : addLine(output, "beeped", 1, block, tick);
  return { ...output, beeps, talk };
}

function newest<T>(all: readonly T[], one: T, maxLength: number): readonly T[] {
  return [...(all.length < maxLength ? all : all.slice(1 - maxLength)), one];
}

function drawn(output: Output, point: Point): Output {
  const { pen } = output;
  if (!pen) return output;
  const trail = extend(pen.trail, point);
  return trail === pen.trail ? output : { ...output, pen: { ...pen, trail } };
}

/** A new colour starts a new stroke at the end of the last one. */
function withPen(output: Output, color: string | null, at: Point): Output {
  const { pen } = output;
  if (color === (pen?.color ?? null)) return output;
  const done = pen && { ...pen, trail: extend(pen.trail, at, Number.EPSILON) };
  const strokes = done && !isRepeated(output.strokes.at(-1), done);
  return {
    ...output,
    strokes: strokes ? newest(output.strokes, done, MAX_STROKES) : output.strokes,
    pen: color === null ? null : { color, trail: extend(EMPTY_TRAIL, at) },
  };
}

/** Whether a stroke repeats the dot before it: repeated pen down and up at one point is one dot. */
function isRepeated(before: Stroke | undefined, stroke: Stroke): boolean {
  const isDot = stroke.trail.chunks.length === 0 && stroke.trail.tail.length < 2;
  const [x, y] = lastPoint(stroke.trail) ?? [0, 0];
  const last = before && lastPoint(before.trail);
  return isDot && before?.color === stroke.color && last?.[0] === x && last[1] === y;
}
