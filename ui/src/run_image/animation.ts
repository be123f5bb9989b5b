import { END_S, FRAMES_PER_S, planFrames } from "./frame_plan";
import { GifAnimation } from "./gif";

/** A file that fits into a message and loads at once from a slow stick. */
export const MAX_BYTES = 4_000_000;
/** An animation that is too large is made again with half the frames, down to this rate. */
const MIN_FRAMES_PER_S = FRAMES_PER_S / 16;

export interface Progress {
  /** Called with the finished part, 0 to 1. */
  onProgress(part: number): void;
  /** Ends the work; nothing is saved. */
  readonly signal: AbortSignal;
}

/** Draws the frame of a tick; `speed` is how much faster than the run the animation is. */
type DrawFrame = (tick: number, speed: number) => ImageData;

/** Encodes an animation of a run, in as many frames as `maxBytes` allow. Returns null if the work was ended. */
export async function encodeAnimation(
  lastTick: number,
  draw: DrawFrame,
  progress: Progress,
  maxBytes = MAX_BYTES,
): Promise<Blob | null> {
  for (let rate = FRAMES_PER_S; ; rate /= 2) {
    const limit = rate > MIN_FRAMES_PER_S ? maxBytes : Number.POSITIVE_INFINITY;
    const gif = await encodeAt(rate, lastTick, draw, progress, limit);
    if (progress.signal.aborted) return null;
    if (gif) return gif.finish();
  }
}

/** Encodes one frame at a time, each in a task of its own. Returns null if the file becomes larger than `limit`. */
async function encodeAt(
  framesPerS: number,
  lastTick: number,
  draw: DrawFrame,
  { onProgress, signal }: Progress,
  limit: number,
): Promise<GifAnimation | null> {
  const { ticks, speed } = planFrames(lastTick, framesPerS);
  const gif = new GifAnimation([draw(0, speed), draw(lastTick, speed)]);
  for (const [index, tick] of ticks.entries()) {
    await nextTask();
    if (signal.aborted) return null;
    const isLast = index === ticks.length - 1;
    gif.add(draw(tick, speed), 1000 * (isLast ? END_S : 1 / framesPerS));
    if (gif.size >= limit) return null;
    onProgress((index + 1) / ticks.length);
  }
  return gif;
}

const nextTask = () => new Promise((done) => setTimeout(done));
