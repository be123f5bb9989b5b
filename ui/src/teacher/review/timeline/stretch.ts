/** A point in time on a timeline, with its minimum distance in pixels from the preceding point. */
export interface TimePoint {
  readonly time: number;
  readonly gap: number;
}

/** Positions of all points in one scale: linear where possible, stretched where events are dense. */
export interface Stretched {
  /** Positions by timeline and point, in pixels. */
  readonly positions: readonly (readonly number[])[];
  /** Pairs of time and position, both increasing. */
  readonly knots: readonly (readonly [number, number])[];
  readonly end: number;
}

const STEPS = 24;

/**
 * Computes one scale for many timelines. A time has the same position on all of them, and the points
 * of a timeline keep their minimum distances. The scale is as linear as the width allows.
 */
export function stretch(lines: readonly (readonly TimePoint[])[], room: number): Stretched {
  const sorted = lines
    .flatMap((points, line) => points.map((point, index) => ({ ...point, line, index })))
    .sort((a, b) => a.time - b.time || a.index - b.index);
  const length = (sorted.at(-1)?.time ?? 0) - (sorted[0]?.time ?? 0);
  let [low, high] = [0, room / Math.max(1, length)];
  for (let step = 0; step < STEPS; step++) {
    const middle = (low + high) / 2;
    if (laid(lines.length, sorted, middle).end > room) high = middle;
    else low = middle;
  }
  return laid(lines.length, sorted, low);
}

interface Placed extends TimePoint {
  readonly line: number;
  readonly index: number;
}

/** Leftmost positions of all points in a scale of at least `perSecond` pixels per second. */
function laid(count: number, sorted: readonly Placed[], perSecond: number): Stretched {
  const positions: number[][] = Array.from({ length: count }, () => []);
  const knots: [number, number][] = [];
  let [time, reached] = [sorted[0]?.time ?? 0, 0];
  for (const point of sorted) {
    const before = positions[point.line]?.at(-1) ?? 0;
    reached = Math.max(reached + (point.time - time) * perSecond, before + point.gap);
    time = point.time;
    positions[point.line]?.push(reached);
    const last = knots.at(-1);
    if (last?.[0] === time) last[1] = reached;
    else knots.push([time, reached]);
  }
  return { positions, knots, end: reached };
}
