import type { Colours } from "../colours";
import type { XY } from "../frames";

type Ctx = CanvasRenderingContext2D;

/** Half the angle of an arc, in radians; distance between the arcs and widths of their lines, in pixels. */
const HALF_ARC = 0.75;
const GAP_PX = 11;
const LINE_PX = 5;
const EDGE_PX = 9;
const ARCS = 3;

/** Width of all arcs beside the robot, in pixels. */
export const WAVES_PX = GAP_PX * ARCS;

/**
 * Draws sound waves beside the robot at `at`, in pixels of the canvas. The first begins `reach` pixels from its centre;
 * `grown` is how far they have spread, 0 to 1.
 */
export function drawWaves(ctx: Ctx, at: XY, reach: number, grown: number, colours: Colours): void {
  ctx.save();
  ctx.lineCap = "round";
  for (const [colour, width] of [
    [colours.tile, EDGE_PX],
    [colours.ink, LINE_PX],
  ] as const) {
    ctx.beginPath();
    for (let arc = 0; arc < ARCS; arc++) wave(ctx, at, reach + arc * GAP_PX * grown);
    ctx.strokeStyle = colour;
    ctx.lineWidth = width;
    ctx.stroke();
  }
  ctx.restore();
}

function wave(ctx: Ctx, { x, y }: XY, radius: number): void {
  for (const middle of [0, Math.PI]) {
    ctx.moveTo(x + radius * Math.cos(middle - HALF_ARC), y + radius * Math.sin(middle - HALF_ARC));
    ctx.arc(x, y, radius, middle - HALF_ARC, middle + HALF_ARC);
  }
}
