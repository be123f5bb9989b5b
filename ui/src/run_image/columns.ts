/** A block's size, at scale 1. */
interface Sized {
  readonly width: number;
  readonly height: number;
}

/** A block in a column, its corner in pixels. */
export interface Placed<Block> {
  readonly block: Block;
  readonly x: number;
  readonly y: number;
}

export interface Columns<Block> {
  readonly placed: readonly Placed<Block>[];
  readonly scale: number;
  /** Height of the longest column, in pixels; more than the height offered if the program is very long. */
  readonly height: number;
}

/** Space for blocks, and the scales at which they can be read. */
export interface Area {
  readonly width: number;
  readonly height: number;
  readonly maxScale: number;
  readonly minScale: number;
}

/** Gaps between columns and between stacks, at scale 1. */
const BESIDE = 28;
const BETWEEN = 24;
const SCALE_STEP = 0.05;
const GROWTH = 1.1;

/**
 * Places stacks of blocks in columns, at the largest scale at which all fit. A stack continues in the
 * next column; no block is cut. If they do not fit at the smallest scale, the columns become longer.
 */
export function columnsOf<Block extends Sized>(
  stacks: readonly (readonly Block[])[],
  area: Area,
): Columns<Block> {
  const widest = Math.max(1, ...stacks.flat().map(({ width }) => width));
  // a block that is wider than the area is made smaller than the others may be
  const minScale = Math.min(area.minScale, area.width / widest);
  for (let scale = area.maxScale; scale > minScale; scale -= SCALE_STEP) {
    const tried = placeAll(stacks, area.height / scale);
    if (tried.width * scale <= area.width && tried.height * scale <= area.height)
      return scaled(tried, scale);
  }
  let { height } = area;
  for (;;) {
    const tried = placeAll(stacks, height / minScale);
    if (tried.width * minScale <= area.width + 1) return scaled(tried, minScale);
    height *= GROWTH;
  }
}

interface Tried<Block> extends Sized {
  readonly placed: readonly Placed<Block>[];
}

/** Places all blocks at scale 1 in columns of a height; a block higher than that has a column to itself. */
function placeAll<Block extends Sized>(
  stacks: readonly (readonly Block[])[],
  columnHeight: number,
): Tried<Block> {
  const placed: Placed<Block>[] = [];
  let [x, y, width, height] = [0, 0, 0, 0];
  for (const stack of stacks) {
    if (y > 0) y += BETWEEN;
    for (const block of stack) {
      if (y > 0 && y + block.height > columnHeight) {
        x += width + BESIDE;
        [y, width] = [0, 0];
      }
      placed.push({ block, x, y });
      y += block.height;
      width = Math.max(width, block.width);
      height = Math.max(height, y);
    }
  }
  return { placed, width: x + width, height };
}

function scaled<Block>({ placed, height }: Tried<Block>, scale: number): Columns<Block> {
  return {
    placed: placed.map(({ block, x, y }) => ({ block, x: x * scale, y: y * scale })),
    scale,
    height: height * scale,
  };
}
