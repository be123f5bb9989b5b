import type { Colours } from "./colours";
import type { XY } from "./frames";
import type { Size } from "./viewport";

type Ctx = CanvasRenderingContext2D;

/** Half the angle of an arc, in radians; distance between the arcs and widths of their lines, in pixels. */
const HALF_ARC = 0.75;
const GAP_PX = 11;
const LINE_PX = 5;
const EDGE_PX = 9;
const ARCS = 3;

/** Gap between the robot's circle and the first arc, in metres; minimum radius of that arc, in pixels. */
const FREE_M = 0.08;
const FREE_PX = 16;

/** Duration in which the arcs spread from the robot, in ms. Only the first of consecutive beeps moves them. */
export const GROWING_MS = 160;

/** Minimum distance of the text from the upper edge, in pixels: controls cover the floor above. */
const TOP_PX = 76;
const CHIP_PX = 36;

/** The drawing that shows a beep. */
export interface Beeping {
  /** The short text above the robot. */
  readonly text: string;
  /** Radius of the robot's circle in metres. */
  readonly radius: number;
  /** Progress of the arcs' spread from the robot, 0 to 1. */
  readonly grown: number;
}

/**
 * Draws sound waves beside the robot at `at` and the text above it, in pixels of the canvas.
 * `scale` is in pixels per metre.
 */
export function drawBeep(
  ctx: Ctx,
  { text, radius, grown }: Beeping,
  at: XY,
  [scale, size]: readonly [number, Size],
  colours: Colours,
): void {
  const free = Math.max(FREE_PX, (radius + FREE_M) * scale);
  ctx.save();
  ctx.lineCap = "round";
  for (const [colour, width] of [
    [colours.tile, EDGE_PX],
    [colours.ink, LINE_PX],
  ] as const) {
    ctx.beginPath();
    for (let arc = 0; arc < ARCS; arc++) wave(ctx, at, free + arc * GAP_PX * grown);
    ctx.strokeStyle = colour;
    ctx.lineWidth = width;
    ctx.stroke();
  }
  drawText(ctx, text, at, [free + GAP_PX * ARCS, size], colours);
  ctx.restore();
}

function wave(ctx: Ctx, { x, y }: XY, radius: number): void {
  for (const middle of [0, Math.PI]) {
    ctx.moveTo(x + radius * Math.cos(middle - HALF_ARC), y + radius * Math.sin(middle - HALF_ARC));
    ctx.arc(x, y, radius, middle - HALF_ARC, middle + HALF_ARC);
  }
}

function drawText(
  ctx: Ctx,
  text: string,
  at: XY,
  [reach, size]: readonly [number, Size],
  colours: Colours,
): void {
  ctx.font = `700 20px ${colours.font}`;
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  const half = ctx.measureText(text).width / 2 + 14;
  const above = at.y - reach - CHIP_PX / 2;
  const middleY = above < TOP_PX ? at.y + reach + CHIP_PX / 2 : above;
  const x = Math.min(size.width - half - 4, Math.max(half + 4, at.x));
  const y = Math.min(size.height - CHIP_PX, Math.max(CHIP_PX, middleY));
  ctx.beginPath();
  ctx.roundRect(x - half, y - CHIP_PX / 2, 2 * half, CHIP_PX, CHIP_PX / 2);
  ctx.fillStyle = colours.ink;
  ctx.fill();
  ctx.strokeStyle = colours.tile;
  ctx.lineWidth = 2;
  ctx.stroke();
  ctx.fillStyle = colours.tile;
  ctx.fillText(text, x, y + 1);
}
