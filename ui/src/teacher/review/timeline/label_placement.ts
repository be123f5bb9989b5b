/** Preferred position of an item on a line: centre and width, in pixels. */
export interface PreferredPosition {
  readonly middle: number;
  readonly width: number;
}

/** Gap between neighbours, in pixels. */
export const GAP = 2;

/** Minimum width without overlaps, in pixels. */
export function minWidthFor(preferred: readonly PreferredPosition[]): number {
  return preferred.reduce((sum, { width }) => sum + width + GAP, -GAP);
}

/**
 * Centres of the items without overlaps, in the same order, within 0 to `room` pixels. Minimises the
 * squared distances from the preferred positions. `room` must be at least `minWidthFor(preferred)`.
 * Pool adjacent violators: Best and Chakravarti 1990.
 */
export function spread(preferred: readonly PreferredPosition[], room: number): number[] {
  const offsets: number[] = [];
  let reached = 0;
  for (const { width } of preferred) {
    offsets.push(reached + width / 2);
    reached += width + GAP;
  }
  const freeSpace = Math.max(0, room - (reached - GAP));
  const pools: { sum: number; count: number }[] = [];
  preferred.forEach(({ middle }, index) => {
    let pool = { sum: middle - (offsets[index] ?? 0), count: 1 };
    for (let before = pools.at(-1); before && mean(before) > mean(pool); before = pools.at(-1)) {
      pools.pop();
      pool = { sum: before.sum + pool.sum, count: before.count + pool.count };
    }
    pools.push(pool);
  });
  const shifts = pools.flatMap((pool) => {
    return Array<number>(pool.count).fill(Math.min(freeSpace, Math.max(0, mean(pool))));
  });
  return shifts.map((shift, index) => shift + (offsets[index] ?? 0));
}

const mean = ({ sum, count }: { sum: number; count: number }) => sum / count;

/** Interpolates linearly between known pairs, increasing in both values; extrapolates with the slope `scale`. */
export function between(
  knots: readonly (readonly [number, number])[],
  value: number,
  scale: number,
): number {
  const after = knots.findIndex(([key]) => key > value);
  const next = knots[after];
  const before = after < 0 ? knots.at(-1) : knots[after - 1];
  if (!before) return next ? next[1] - (next[0] - value) * scale : value * scale;
  if (!next) return before[1] + (value - before[0]) * scale;
  const part = (value - before[0]) / (next[0] - before[0]);
  return before[1] + part * (next[1] - before[1]);
}
