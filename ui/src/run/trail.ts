/** x, y in metres, start frame. */
export type Point = readonly [x: number, y: number];

/**
 * A growing line that shares its points with earlier states: adding a point copies at most one chunk, so a reducer
 * can keep every state of a long run.
 */
export interface Trail {
  readonly chunks: readonly (readonly Point[])[];
  readonly tail: readonly Point[];
}

const CHUNK = 64;
/** Points closer than this to the last one are dropped. */
const STEP_M = 0.01;

export const EMPTY_TRAIL: Trail = { chunks: [], tail: [] };

export function lastPoint(trail: Trail): Point | undefined {
  return trail.tail.at(-1) ?? trail.chunks.at(-1)?.at(-1);
}

export function extend(trail: Trail, point: Point, step = STEP_M): Trail {
  const last = lastPoint(trail);
  if (last && Math.hypot(point[0] - last[0], point[1] - last[1]) < step) return trail;
  if (trail.tail.length < CHUNK) return { chunks: trail.chunks, tail: [...trail.tail, point] };
  return { chunks: [...trail.chunks, trail.tail], tail: [point] };
}

export function* points(trail: Trail): Generator<Point> {
  for (const chunk of trail.chunks) yield* chunk;
  yield* trail.tail;
}
