import { type Axis, type Fold, type Span, stepFor } from "./axis";
import type { ReviewMark } from "./model";
import { between, GAP, roomFor, spread } from "./places";
import type { Moment } from "./stretch";

/** A round mark, and the smallest one that still shows its sign; in pixels. */
export const ROUND = 26;
const SMALLEST = 16;
/** Round marks where many lines share one scale. */
const DENSE = 20;
const THINNEST_BAR = 10;
const LOWEST_BAR = 8;
const HIGHEST_BAR = 30;
/** Numbers under the line are so far apart. */
const RULER_APART = 72;
/** What is left and right of the line. */
const EDGE = 4;

export interface PlacedMark {
  readonly mark: ReviewMark;
  readonly index: number;
  /** Its middle and its size, in pixels. */
  readonly x: number;
  readonly width: number;
  readonly height: number;
}

export interface Arc {
  readonly from: number;
  readonly to: number;
}

export interface LineLayout {
  readonly width: number;
  readonly marks: readonly PlacedMark[];
  /** From each failing run to the one that made it good. */
  readonly arcs: readonly Arc[];
  readonly ticks: readonly { readonly x: number; readonly time: number }[];
  readonly folds: readonly { readonly x: number; readonly fold: Fold }[];
  /** Runs that went on beyond the sign of their beginning. */
  readonly lengths: readonly Arc[];
  /** Where the time of the line is over. */
  readonly end: number;
}

/** Places that were found for all lines together. */
export interface Common {
  /** The moments of this line as `momentsOf` has them. */
  readonly places: readonly number[];
  readonly knots: readonly (readonly [number, number])[];
  readonly end: number;
}

interface LineInput {
  marks: readonly ReviewMark[];
  spans: readonly Span[];
  axis: Axis;
  /** The line's room in pixels, and how much a second takes of it. */
  width: number;
  scale: number;
  /** Where the ruler's numbers count from, seconds. */
  zero: number;
  /** Missing where each line has a scale of its own. */
  common?: Common;
}

/** The moments of a line: one for each run, and the beginning and the end of each burst of edits. */
export function momentsOf(
  marks: readonly ReviewMark[],
  spans: readonly Span[],
  axis: Axis,
): Moment[] {
  let right = 0;
  return marks.flatMap(({ kind }, index): Moment[] => {
    const { from, to } = spans[index] ?? { from: 0, to: 0 };
    const before = right;
    right = kind === "run" ? DENSE / 2 : 0;
    if (kind === "run") return [{ time: axis.at(from), gap: before + DENSE / 2 + GAP }];
    return [
      { time: axis.at(from), gap: before + GAP },
      { time: axis.at(to), gap: (THINNEST_BAR * DENSE) / ROUND },
    ];
  });
}

/** Where everything on a line stands that shares its scale with others. */
function layOutCommon(line: LineInput, common: Common): LineLayout {
  const { marks, axis, width, scale } = line;
  let next = 0;
  const take = () => EDGE + (common.places[next++] ?? 0);
  const placed = marks.map((mark, index): PlacedMark => {
    const from = take();
    if (mark.kind === "run") return { mark, index, x: from, width: DENSE, height: DENSE };
    const to = take();
    const height = barHeight(mark.n_edits ?? 1);
    return { mark, index, x: (from + to) / 2, width: to - from, height };
  });
  const place = (time: number) => EDGE + between(common.knots, axis.at(time), scale);
  const room = Math.max(width - 2 * EDGE, common.end + DENSE / 2);
  return {
    width: room + 2 * EDGE,
    marks: placed,
    arcs: arcsOf(placed),
    ...rulerOf(line, placed, place, room),
  };
}

/** Where everything on a line stands. The ruler goes with the marks where these had to make room for each other. */
export function layOut(line: LineInput): LineLayout {
  const { marks, spans, axis, width, scale, common } = line;
  if (common) return layOutCommon(line, common);
  const inner = width - 2 * EDGE;
  const begin = (index: number) => axis.at(spans[index]?.from ?? 0) * scale;
  const end = (index: number) => axis.at(spans[index]?.to ?? 0) * scale;
  const round = roundFor(marks, inner);
  const wishes = marks.map(({ kind }, index) => {
    const wide = Math.max(THINNEST_BAR * (round / ROUND), end(index) - begin(index));
    return kind === "run"
      ? { middle: begin(index), width: round }
      : { middle: (begin(index) + end(index)) / 2, width: Math.min(wide, inner / 2) };
  });
  const tight = roomFor(wishes) > inner;
  const fitted = tight ? wishes.map((wish, index) => narrow(wish, marks[index], round)) : wishes;
  const room = Math.max(inner, roomFor(fitted));
  const places = spread(fitted, room);
  const placed = marks.map((mark, index) => ({
    mark,
    index,
    x: EDGE + (places[index] ?? 0),
    width: fitted[index]?.width ?? round,
    height: mark.kind === "run" ? round : barHeight(mark.n_edits ?? 1),
  }));
  const knots = knotsOf(placed, marks, begin, end);
  const place = (time: number) => EDGE + between(knots, axis.at(time) * scale, scale);
  return {
    width: room + 2 * EDGE,
    marks: placed,
    arcs: arcsOf(placed),
    ...rulerOf(line, placed, place, room),
  };
}

/** Many edits are a higher bar than few, but not so much higher that few cannot be seen. */
export function barHeight(edits: number): number {
  return Math.min(HIGHEST_BAR, LOWEST_BAR + 4 * Math.sqrt(Math.max(0, edits - 1)));
}

/** Marks get smaller before the line gets longer than its room. */
function roundFor(marks: readonly ReviewMark[], room: number): number {
  const parts = marks.reduce(
    (sum, { kind }) => sum + (kind === "run" ? 1 : THINNEST_BAR / ROUND),
    0,
  );
  return Math.max(SMALLEST, Math.min(ROUND, room / Math.max(1, parts) - 3));
}

function narrow(
  wish: { middle: number; width: number },
  mark: ReviewMark | undefined,
  round: number,
): { middle: number; width: number } {
  return mark?.kind === "run" ? wish : { ...wish, width: (THINNEST_BAR * round) / ROUND };
}

type At = (index: number) => number;

/** Pairs of time (in pixels of an even line) and place that only rise. */
function knotsOf(
  placed: readonly PlacedMark[],
  marks: readonly ReviewMark[],
  begin: At,
  end: At,
): (readonly [number, number])[] {
  const knots: (readonly [number, number])[] = [];
  placed.forEach(({ x, width }, index) => {
    const isRun = marks[index]?.kind === "run";
    const middle = x - EDGE;
    const pairs = isRun
      ? [[begin(index), middle] as const]
      : [[begin(index), middle - width / 2] as const, [end(index), middle + width / 2] as const];
    for (const pair of pairs) if (pair[0] > (knots.at(-1)?.[0] ?? -1)) knots.push(pair);
  });
  return knots;
}

function arcsOf(placed: readonly PlacedMark[]): Arc[] {
  const places = new Map(placed.map(({ mark, x }) => [mark.run_id, x]));
  return placed.flatMap(({ mark, x }) => {
    const from = mark.repairs ? places.get(mark.repairs) : undefined;
    return from === undefined ? [] : [{ from, to: x }];
  });
}

type Ruler = Pick<LineLayout, "ticks" | "folds" | "lengths" | "end">;

/** What lies under the marks: the time itself. */
function rulerOf(
  { axis, scale, zero, spans }: LineInput,
  placed: readonly PlacedMark[],
  place: At,
  room: number,
): Ruler {
  const within = (time: number) => Math.min(EDGE + room, place(time));
  return {
    ticks: ticksOf(axis, scale, zero, place, room),
    folds: axis.folds.map((fold) => ({ fold, x: place(fold.from + fold.seconds / 2) })),
    lengths: placed.flatMap(({ mark, index, x, width }) => {
      const to = within(spans[index]?.to ?? 0);
      return mark.kind === "run" && to > x + width / 2 ? [{ from: x, to }] : [];
    }),
    end: within(axis.to),
  };
}

function ticksOf(
  axis: Axis,
  scale: number,
  zero: number,
  place: (time: number) => number,
  room: number,
): { x: number; time: number }[] {
  const step = stepFor(scale, RULER_APART);
  const ticks: { x: number; time: number }[] = [];
  const first = Math.ceil((axis.from - zero) / step);
  for (let count = first; zero + count * step <= axis.to; count++) {
    const time = zero + count * step;
    const x = place(time);
    const before = ticks.at(-1)?.x ?? Number.NEGATIVE_INFINITY;
    if (axis.isFolded(time) || x - before < RULER_APART * 0.7 || x > room) continue;
    ticks.push({ x, time });
  }
  return ticks;
}
