/** An interval of time, in seconds. */
export interface Span {
  readonly from: number;
  readonly to: number;
}

/** A shortened pause: its position on the axis and its real length, in seconds. */
export interface Fold {
  readonly at: number;
  readonly from: number;
  readonly seconds: number;
}

/** Minimum length of a folded pause; the metrics exclude such pauses from the active time too. */
export const FOLD_S = 300;
/** Drawn length of a folded pause. */
export const FOLDED_S = 60;

/**
 * Maps time to positions in seconds, with folded pauses shortened. Built from all events of the
 * timeline.
 */
export class Axis {
  readonly folds: readonly Fold[];
  readonly from: number;
  readonly to: number;

  constructor(spans: readonly Span[]) {
    const sorted = [...spans].sort((a, b) => a.from - b.from);
    this.from = sorted[0]?.from ?? 0;
    const folds: Fold[] = [];
    let reached = this.from;
    let left = 0;
    for (const { from, to } of sorted) {
      const pause = from - reached;
      if (pause > FOLD_S) {
        folds.push({ at: reached - this.from - left, from: reached, seconds: pause });
        left += pause - FOLDED_S;
      }
      reached = Math.max(reached, to);
    }
    this.folds = folds;
    this.to = reached;
  }

  /** The position of a time, in seconds from the beginning of the timeline. */
  at(time: number): number {
    let shown = time - this.from;
    for (const { from, seconds } of this.folds) {
      if (time >= from + seconds) shown -= seconds - FOLDED_S;
      else if (time > from) shown -= (time - from) * (1 - FOLDED_S / seconds);
    }
    return shown;
  }

  /** Length of the timeline with folded pauses, in seconds. */
  get length(): number {
    return this.at(this.to);
  }

  isFolded(time: number): boolean {
    return this.folds.some(({ from, seconds }) => time > from && time < from + seconds);
  }
}

interface Timed {
  readonly at: string;
  readonly until?: string | null;
  readonly duration_s?: number | null;
}

/**
 * Begin and end of each timeline event, in seconds since 1970. The events are in their true order. If
 * the PC's clock was set back in between, later times are shifted so that the order stays.
 */
export function spansOf(entries: readonly Timed[]): Span[] {
  let shift = 0;
  let last = Number.NEGATIVE_INFINITY;
  return entries.map(({ at, until, duration_s }) => {
    const start = Date.parse(at) / 1000;
    if (start + shift < last) shift = last - start;
    const took = until ? Math.max(0, Date.parse(until) / 1000 - start) : (duration_s ?? 0);
    last = start + shift;
    return { from: last, to: last + took };
  });
}

const STEPS_S = [60, 120, 300, 600, 900, 1800, 3600, 7200, 14_400, 28_800, 86_400];

/** Interval of a ruler in seconds, for ticks at least `spacing` pixels apart. */
export function stepFor(pixelsPerSecond: number, spacing: number): number {
  return STEPS_S.find((step) => step * pixelsPerSecond >= spacing) ?? 86_400;
}
