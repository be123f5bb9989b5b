/** A part of the window, in pixels. */
export interface Box {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** Gap between the balloon and the box beside it, and margin of a ring; pixels. */
const GAP = 12;
const RING = 4;

export const ringOf = ({ x, y, width, height }: Box): Box => ({
  x: x - RING,
  y: y - RING,
  width: width + 2 * RING,
  height: height + 2 * RING,
});

interface BalloonPlacement {
  size: Pick<Box, "width" | "height">;
  /** The box beside which the balloon is placed. */
  beside: Box;
  /** Boxes that the step needs, so that the balloon must not cover them. */
  free: readonly Box[];
  window: Pick<Box, "width" | "height">;
}

/**
 * Upper left corner of a balloon beside a part of the page. Tries below, left, right and above, and
 * takes the first position inside the window that covers no box of `free`. If none exists, takes the
 * lower edge of the window.
 */
export function placeBeside({ size, beside, free, window }: BalloonPlacement): {
  x: number;
  y: number;
} {
  const max = { x: window.width - size.width - GAP, y: window.height - size.height - GAP };
  const x = clamped(beside.x, GAP, max.x);
  const y = clamped(beside.y + beside.height / 2 - size.height / 2, GAP, max.y);
  const places = [
    { x, y: beside.y + beside.height + GAP },
    { x: beside.x - size.width - GAP, y },
    { x: beside.x + beside.width + GAP, y },
    { x, y: beside.y - size.height - GAP },
  ];
  const fits = (one: { x: number; y: number }) =>
    one.x >= 0 &&
    one.y >= 0 &&
    one.x <= max.x + GAP &&
    one.y <= max.y + GAP &&
    !free.some((box) => shared({ ...one, ...size }, box));
  return places.find(fits) ?? { x, y: max.y };
}

/** The intersection of two boxes; null if they do not overlap. */
export function shared(one: Box, other: Box): Box | null {
  const [x, y] = [Math.max(one.x, other.x), Math.max(one.y, other.y)];
  const width = Math.min(one.x + one.width, other.x + other.width) - x;
  const height = Math.min(one.y + one.height, other.y + other.height) - y;
  return width > 0 && height > 0 ? { x, y, width, height } : null;
}

const clamped = (value: number, min: number, max: number) => Math.max(min, Math.min(value, max));
