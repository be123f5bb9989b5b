/** How carefully frames are drawn. */
export interface Quality {
  readonly antialias: boolean;
  /** Largest number of pixels of a frame for each pixel of the page, along one side. */
  readonly ratio: number;
  /** Largest size of a frame; a larger view is stretched. */
  readonly size: readonly [width: number, height: number] | null;
  readonly shadows: boolean;
  /** Longer side of the picture on the floor, pixels, and how sharp it is where it lies flat to the view. */
  readonly floor: readonly [size: number, anisotropy: number];
}

/** From fine to fast. The view only ever goes down: a PC that was too slow once would be so again. */
export const QUALITIES: readonly Quality[] = [
  { antialias: true, ratio: 2, size: null, shadows: true, floor: [2048, 4] },
  { antialias: false, ratio: 1, size: null, shadows: true, floor: [2048, 1] },
  { antialias: false, ratio: 1, size: [640, 480], shadows: true, floor: [1024, 1] },
  { antialias: false, ratio: 1, size: [640, 480], shadows: false, floor: [1024, 1] },
];

export const LAST_LEVEL = QUALITIES.length - 1;

export const qualityOf = (level: number): Quality =>
  QUALITIES[Math.min(level, LAST_LEVEL)] as Quality;

/** Frames that are measured before a step, and fewer where each takes long. */
const MEASURED = 30;
const MEASURED_IF_SLOW = 8;

/** Slower frames than this make a step down, at once if they are very slow; ms. */
const SLOW_MS = 36;
const VERY_SLOW_MS = 90;
/** A longer gap is no frame: the window was hidden, or the view was still. */
const GAP_MS = 400;

/** Measures frames that follow each other, and says when they are too slow. */
export class FrameTimer {
  private gaps: number[] = [];

  /** Adds the time between two frames that followed each other, ms; true if the view must draw less. */
  isTooSlow(gapMs: number): boolean {
    if (gapMs > GAP_MS) return false;
    this.gaps.push(gapMs);
    const median = medianOf(this.gaps);
    const n = this.gaps.length;
    const isOver = n >= MEASURED || (n >= MEASURED_IF_SLOW && median > VERY_SLOW_MS);
    if (!isOver) return false;
    this.gaps = [];
    return median > SLOW_MS;
  }
}

const medianOf = (values: readonly number[]) =>
  [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)] ?? 0;

/** The size of a frame in pixels, for a view of a size in pixels of the page. */
export function frameSize(
  { ratio, size }: Quality,
  [width, height]: readonly [number, number],
  pixelRatio: number,
): [width: number, height: number] {
  const fine = Math.min(ratio, Math.max(1, pixelRatio));
  const fit = size ? Math.min(1, size[0] / width, size[1] / height) : fine;
  return [Math.max(1, Math.round(width * fit)), Math.max(1, Math.round(height * fit))];
}
