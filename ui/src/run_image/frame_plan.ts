/** Robot time of a tick, in seconds. */
const TICK_S = 1 / 30;

/** Pictures a second of an animation, if its file does not become too large. */
export const FRAMES_PER_S = 10;
/** Longest time in which an animation shows its run; a longer run is played faster. */
export const MAX_PLAYED_S = 18;
/** Time for which the end of the run is shown, before the animation begins again. */
export const END_S = 2;

/** Which states of a run an animation shows. */
export interface FramePlan {
  /** The tick of each picture: the start of the run first, its end last. */
  readonly ticks: readonly number[];
  /** How much faster than the run it is: 1, 2, 4, ... */
  readonly speed: number;
}

export function planFrames(lastTick: number, framesPerS = FRAMES_PER_S): FramePlan {
  const run_s = lastTick * TICK_S;
  let speed = 1;
  while (run_s / speed > MAX_PLAYED_S) speed *= 2;
  const intervals = Math.ceil((run_s / speed) * framesPerS);
  const ticks = Array.from({ length: intervals }, (_, index) => (index * lastTick) / intervals);
  return { ticks: [...ticks, lastTick], speed };
}
