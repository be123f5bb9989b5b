import type { FloorMark, Stroke } from "../run/output";
import { lastPoint, type Point, points } from "../run/trail";
import type { Colours } from "./colours";
import { edgeOf, paintOf } from "./paints";

type Ctx = CanvasRenderingContext2D;

/** Width of the pen's line in metres, with a minimum in pixels: the line covers the path below it. */
export const PEN_M = 0.07;
const PEN_PX = 7;
const EDGE_PX = 1.5;

/** Radius of a mark and the width of its line, metres. */
export const MARK_M = 0.3;
export const MARK_LINE_M = 0.075;

/** Draws a stroke of the pen; an unfinished stroke ends at the robot (`end`). Start frame, metres. */
export function drawStroke(
  ctx: Ctx,
  stroke: Stroke,
  end: Point | null,
  colours: Colours,
  pixel: number,
): void {
  ctx.lineCap = "round";
  ctx.lineJoin = "round";
  const paint = paintOf(stroke.color);
  const edge = edgeOf(paint, colours.tile, colours.number);
  const width = Math.max(PEN_M, PEN_PX * pixel);
  trace(ctx, stroke);
  if (end) ctx.lineTo(...end);
  if (edge) paintLine(ctx, edge, width + 2 * EDGE_PX * pixel);
  paintLine(ctx, paint, width);
}

function trace(ctx: Ctx, { trail }: Stroke): void {
  ctx.beginPath();
  for (const [x, y] of points(trail)) ctx.lineTo(x, y);
  // a line of length zero draws a dot for a single point
  const [x, y] = lastPoint(trail) ?? [0, 0];
  ctx.lineTo(x, y);
}

function paintLine(ctx: Ctx, colour: string, width: number): void {
  ctx.strokeStyle = colour;
  ctx.lineWidth = width;
  ctx.stroke();
}

/** Draws the X and O marks of the program. */
export function drawMarks(ctx: Ctx, marks: readonly FloorMark[], colours: Colours): void {
  ctx.lineCap = "round";
  for (const mark of marks) {
    ctx.save();
    ctx.translate(mark.x, mark.y);
    ctx.beginPath();
    if (mark.symbol === "X") cross(ctx);
    else ctx.arc(0, 0, MARK_M, 0, 2 * Math.PI);
    // an edge in the floor's colour separates it from the path and from other marks
    paintLine(ctx, colours.tile, MARK_LINE_M + 0.04);
    paintLine(ctx, mark.symbol === "X" ? colours.markX : colours.markO, MARK_LINE_M);
    ctx.restore();
  }
}

function cross(ctx: Ctx): void {
  const reach = MARK_M * 0.9;
  for (const sign of [-1, 1]) {
    ctx.moveTo(-reach, -reach * sign);
    ctx.lineTo(reach, reach * sign);
  }
}
