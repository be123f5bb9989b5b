/** A moment on a group's line, and how far it must be at least from the one before it on that line, in pixels. */
export interface Moment {
  readonly time: number;
  readonly gap: number;
}

/** Places of all moments in one scale: time goes on evenly where there is room, and slower where marks are dense. */
export interface Stretched {
  /** By line and moment, in pixels. */
  readonly places: readonly (readonly number[])[];
  /** Pairs of time and place, both of them rising. */
  readonly knots: readonly (readonly [number, number])[];
  readonly end: number;
}

const STEPS = 24;

/**
 * One scale for many lines, so that the same time stands at the same place of all of them, and no two moments of a line
 * are nearer than they may be. As even as the room allows.
 */
export function stretch(lines: readonly (readonly Moment[])[], room: number): Stretched {
  const sorted = lines
    .flatMap((moments, line) => moments.map((moment, index) => ({ ...moment, line, index })))
    .sort((a, b) => a.time - b.time || a.index - b.index);
  const length = (sorted.at(-1)?.time ?? 0) - (sorted[0]?.time ?? 0);
  let [least, most] = [0, room / Math.max(1, length)];
  for (let step = 0; step < STEPS; step++) {
    const middle = (least + most) / 2;
    if (laid(lines.length, sorted, middle).end > room) most = middle;
    else least = middle;
  }
  return laid(lines.length, sorted, least);
}

interface Placed extends Moment {
  readonly line: number;
  readonly index: number;
}

/** Each moment as far to the left as it may be, where a second takes at least so many pixels. */
function laid(count: number, sorted: readonly Placed[], perSecond: number): Stretched {
  const places: number[][] = Array.from({ length: count }, () => []);
  const knots: [number, number][] = [];
  let [time, reached] = [sorted[0]?.time ?? 0, 0];
  for (const moment of sorted) {
    const before = places[moment.line]?.at(-1) ?? 0;
    reached = Math.max(reached + (moment.time - time) * perSecond, before + moment.gap);
    time = moment.time;
    places[moment.line]?.push(reached);
    const last = knots.at(-1);
    if (last?.[0] === time) last[1] = reached;
    else knots.push([time, reached]);
  }
  return { places, knots, end: reached };
}
