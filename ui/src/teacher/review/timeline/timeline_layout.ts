import type { TimelineEntry } from "../../../api/model";
import { dayOf } from "../days";
import { type Axis, type Fold, type Span, stepFor } from "./axis";
import { between, GAP, minWidthFor, spread } from "./label_placement";
import type { TimePoint } from "./stretch";

/** Diameter of a round icon, and the minimum diameter with a legible symbol; pixels. */
export const ROUND = 26;
const MIN_ROUND = 16;
/** Diameter if many timelines share one scale, pixels. */
const DENSE = 20;
const MIN_BAR_WIDTH = 10;
const MIN_BAR_HEIGHT = 8;
const MAX_BAR_HEIGHT = 30;
/** Minimum distance between the ruler's labels, in pixels. */
const RULER_SPACING = 72;
/** Widths of a day's label and of a folded pause's label under the timeline, in pixels. */
const DAY_SPACING = 84;
const FOLD_SPACING = 56;
/** Margin left and right of the timeline, in pixels. */
const EDGE = 4;

export interface PlacedEvent {
  readonly entry: TimelineEntry;
  readonly index: number;
  /** Centre and size, in pixels. */
  readonly x: number;
  readonly width: number;
  readonly height: number;
}

export interface Arc {
  readonly from: number;
  readonly to: number;
}

/** A tick of the ruler. */
export interface Tick {
  readonly x: number;
  readonly time: number;
  /** Kind of the label: the day, the time of day, or the minutes since `from`. */
  readonly labelKind: "day" | "clock" | "minutes";
  readonly from: number;
}

/** A folded pause. */
export interface PlacedFold {
  readonly x: number;
  readonly fold: Fold;
  /** Whether a new day starts in the pause. */
  readonly isNight: boolean;
  /** Whether a label fits: the length of the pause, or the new day. */
  readonly isLabelled: boolean;
}

export interface TimelineLayout {
  readonly width: number;
  readonly entries: readonly PlacedEvent[];
  /** Arcs from each failed run to the run that repaired it. */
  readonly arcs: readonly Arc[];
  readonly ticks: readonly Tick[];
  readonly folds: readonly PlacedFold[];
  /** Extents of runs that are longer than their icon. */
  readonly lengths: readonly Arc[];
  /** Position of the end of the group's time. */
  readonly end: number;
}

/** Positions in the shared scale of all timelines. */
export interface Common {
  /** Positions of the elements of `pointsOf` this timeline. */
  readonly positions: readonly number[];
  readonly knots: readonly (readonly [number, number])[];
  readonly end: number;
}

interface TimelineInput {
  entries: readonly TimelineEntry[];
  spans: readonly Span[];
  axis: Axis;
  /** Width of the timeline in pixels, and pixels per second. */
  width: number;
  scale: number;
  /** Whether the ruler shows the time of day instead of minutes. */
  byClock: boolean;
  /** Whether the ruler's first label is the day. */
  withDays: boolean;
  /** Undefined if each timeline has its own scale. */
  common?: Common;
}

/** The points in time of a timeline: one for each run, and the begin and end of each burst of edits. */
export function pointsOf(
  entries: readonly TimelineEntry[],
  spans: readonly Span[],
  axis: Axis,
): TimePoint[] {
  let right = 0;
  return entries.flatMap(({ kind }, index): TimePoint[] => {
    const { from, to } = spans[index] ?? { from: 0, to: 0 };
    const before = right;
    right = kind === "run" ? DENSE / 2 : 0;
    if (kind === "run") return [{ time: axis.at(from), gap: before + DENSE / 2 + GAP }];
    return [
      { time: axis.at(from), gap: before + GAP },
      { time: axis.at(to), gap: (MIN_BAR_WIDTH * DENSE) / ROUND },
    ];
  });
}

/** The layout of a timeline that shares its scale with others. */
function layOutCommon(line: TimelineInput, common: Common): TimelineLayout {
  const { entries, axis, width, scale } = line;
  let next = 0;
  const nextPosition = () => EDGE + (common.positions[next++] ?? 0);
  const placed = entries.map((entry, index): PlacedEvent => {
    const from = nextPosition();
    if (entry.kind === "run") return { entry, index, x: from, width: DENSE, height: DENSE };
    const to = nextPosition();
    const height = barHeight(entry.n_edits ?? 1);
    return { entry, index, x: (from + to) / 2, width: to - from, height };
  });
  const place = (time: number) => EDGE + between(common.knots, axis.at(time), scale);
  const room = Math.max(width - 2 * EDGE, common.end + DENSE / 2);
  return {
    width: room + 2 * EDGE,
    entries: placed,
    arcs: arcsOf(placed),
    ...rulerOf(line, placed, place, room),
  };
}

/** The layout of a timeline. Where events are moved to avoid overlaps, the ruler is stretched with them. */
export function layOut(line: TimelineInput): TimelineLayout {
  const { entries, spans, axis, width, scale, common } = line;
  if (common) return layOutCommon(line, common);
  const inner = width - 2 * EDGE;
  const begin = (index: number) => axis.at(spans[index]?.from ?? 0) * scale;
  const end = (index: number) => axis.at(spans[index]?.to ?? 0) * scale;
  const round = roundFor(entries, inner);
  const preferred = entries.map(({ kind }, index) => {
    const wide = Math.max(MIN_BAR_WIDTH * (round / ROUND), end(index) - begin(index));
    return kind === "run"
      ? { middle: begin(index), width: round }
      : { middle: (begin(index) + end(index)) / 2, width: Math.min(wide, inner / 2) };
  });
  const tight = minWidthFor(preferred) > inner;
  const fitted = tight
    ? preferred.map((position, index) => narrow(position, entries[index], round))
    : preferred;
  const room = Math.max(inner, minWidthFor(fitted));
  const places = spread(fitted, room);
  const placed = entries.map((entry, index) => ({
    entry,
    index,
    x: EDGE + (places[index] ?? 0),
    width: fitted[index]?.width ?? round,
    height: entry.kind === "run" ? round : barHeight(entry.n_edits ?? 1),
  }));
  const knots = knotsOf(placed, entries, begin, end);
  const place = (time: number) => EDGE + between(knots, axis.at(time) * scale, scale);
  return {
    width: room + 2 * EDGE,
    entries: placed,
    arcs: arcsOf(placed),
    ...rulerOf(line, placed, place, room),
  };
}

/** Height of a bar in pixels: grows with the square root of the edits, so that few edits stay visible. */
export function barHeight(edits: number): number {
  return Math.min(MAX_BAR_HEIGHT, MIN_BAR_HEIGHT + 4 * Math.sqrt(Math.max(0, edits - 1)));
}

/** Diameter of round icons: smaller if they would not fit on the timeline. */
function roundFor(entries: readonly TimelineEntry[], room: number): number {
  const parts = entries.reduce(
    (sum, { kind }) => sum + (kind === "run" ? 1 : MIN_BAR_WIDTH / ROUND),
    0,
  );
  return Math.max(MIN_ROUND, Math.min(ROUND, room / Math.max(1, parts) - 3));
}

function narrow(
  position: { middle: number; width: number },
  entry: TimelineEntry | undefined,
  round: number,
): { middle: number; width: number } {
  return entry?.kind === "run" ? position : { ...position, width: (MIN_BAR_WIDTH * round) / ROUND };
}

type At = (index: number) => number;

/** Increasing pairs of time (in pixels of a linear scale) and position. */
function knotsOf(
  placed: readonly PlacedEvent[],
  entries: readonly TimelineEntry[],
  begin: At,
  end: At,
): (readonly [number, number])[] {
  const knots: (readonly [number, number])[] = [];
  placed.forEach(({ x, width }, index) => {
    const isRun = entries[index]?.kind === "run";
    const middle = x - EDGE;
    const pairs = isRun
      ? [[begin(index), middle] as const]
      : [[begin(index), middle - width / 2] as const, [end(index), middle + width / 2] as const];
    for (const pair of pairs) if (pair[0] > (knots.at(-1)?.[0] ?? -1)) knots.push(pair);
  });
  return knots;
}

function arcsOf(placed: readonly PlacedEvent[]): Arc[] {
  const places = new Map(placed.map(({ entry, x }) => [entry.run_id, x]));
  return placed.flatMap(({ entry, x }) => {
    const from = entry.repairs ? places.get(entry.repairs) : undefined;
    return from === undefined ? [] : [{ from, to: x }];
  });
}

type Ruler = Pick<TimelineLayout, "ticks" | "folds" | "lengths" | "end">;

/** The ruler under the events. */
function rulerOf(
  line: TimelineInput,
  placed: readonly PlacedEvent[],
  place: At,
  room: number,
): Ruler {
  const { axis, spans } = line;
  const within = (time: number) => Math.min(EDGE + room, place(time));
  const folds = foldsOf(line, place);
  return {
    ticks: withoutOverlaps(folds, ticksOf(line, place, room)),
    folds,
    lengths: placed.flatMap(({ entry, index, x, width }) => {
      const to = within(spans[index]?.to ?? 0);
      return entry.kind === "run" && to > x + width / 2 ? [{ from: x, to }] : [];
    }),
    end: within(axis.to),
  };
}

/** The folded pauses; labels of days have precedence over labels of pauses. */
function foldsOf({ axis, withDays }: TimelineInput, place: At): PlacedFold[] {
  const folds = axis.folds.map((fold) => ({ fold, x: place(fold.from + fold.seconds / 2) }));
  const nights = folds.filter(({ fold }) => isNight(fold)).map(({ x }) => x);
  let last = withDays ? place(axis.from) + DAY_SPACING - FOLD_SPACING : Number.NEGATIVE_INFINITY;
  return folds.map(({ fold, x }) => {
    const night = isNight(fold);
    const isFree = [last, ...nights].every((other) => Math.abs(x - other) >= FOLD_SPACING);
    const isLabelled = night || isFree;
    if (isLabelled) last = x;
    return { fold, x, isNight: night, isLabelled: isLabelled };
  });
}

const isNight = ({ from, seconds }: Fold) => dayOf(from) !== dayOf(from + seconds);

/** The ticks that do not overlap the label of a folded pause. */
function withoutOverlaps(folds: readonly PlacedFold[], ticks: readonly Tick[]): Tick[] {
  return ticks.filter(({ x }) =>
    folds.every((fold) => Math.abs(fold.x - x) > (fold.isNight ? DAY_SPACING : 44)),
  );
}

/** The ruler's ticks. Minutes are counted again from each day's start, so that nights do not count. */
function ticksOf(line: TimelineInput, place: At, room: number): Tick[] {
  const { axis, scale, byClock, withDays } = line;
  const step = stepFor(scale, RULER_SPACING);
  const ticks: Tick[] = [];
  if (withDays)
    ticks.push({ x: place(axis.from), time: axis.from, labelKind: "day", from: axis.from });
  for (const { from, to } of daysOn(axis)) {
    const zero = byClock ? dayOf(from) : from;
    for (let count = Math.ceil((from - zero) / step); zero + count * step <= to; count++) {
      const time = zero + count * step;
      const x = place(time);
      const last = ticks.at(-1);
      const minDistance = last?.labelKind === "day" ? DAY_SPACING : RULER_SPACING * 0.7;
      if (axis.isFolded(time) || x > room || (last && x - last.x < minDistance)) continue;
      ticks.push({ x, time, labelKind: byClock ? "clock" : "minutes", from: zero });
    }
  }
  return ticks;
}

/** The spans of the axis between folded nights. */
function daysOn(axis: Axis): Span[] {
  const days: Span[] = [];
  let from = axis.from;
  for (const fold of axis.folds.filter(isNight)) {
    days.push({ from, to: fold.from });
    from = fold.from + fold.seconds;
  }
  return [...days, { from, to: axis.to }];
}
