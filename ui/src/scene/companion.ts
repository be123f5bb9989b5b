import type { Robot, World } from "../api/model";
import type { Pose, RunView } from "../run/reducer";
import { type Point, points } from "../run/trail";
import type { Colours } from "./colours";
import { toStartFrame } from "./frames";
import type { Viewport } from "./framing/viewport";
import type { Livery } from "./livery/livery";
import { drawRobot } from "./robot";

/** A second run on the same floor, with its own start pose. */
export interface Companion {
  readonly world: World | null;
  readonly robot: Robot | null;
  /** Null for the colour of its path. */
  readonly livery: Livery | null;
  readonly view: RunView;
  /** Pieces of the path that a source of truth saw, start frame of the world. */
  readonly measured?: readonly (readonly Point[])[] | undefined;
  pose(): Pose;
}

/** Draws the second run with a dashed path and the measured one dotted, so that no path differs by colour alone. */
export function drawCompanion(
  ctx: CanvasRenderingContext2D,
  { world, robot, livery, view, measured, pose }: Companion,
  { scale }: Viewport,
  colours: Colours,
  ratio: number,
): void {
  const here = pose();
  ctx.save();
  toStartFrame(ctx, world);
  ctx.beginPath();
  for (const point of points(view.path)) ctx.lineTo(...point);
  if (view.run) ctx.lineTo(here.x, here.y);
  ctx.strokeStyle = colours.start;
  ctx.lineWidth = 5 / scale;
  ctx.lineJoin = "round";
  ctx.setLineDash([12 / scale, 7 / scale]);
  ctx.stroke();
  ctx.setLineDash([]);
  for (const piece of measured ?? []) drawDotted(ctx, piece, colours.measured, 1 / scale);
  const itsColours = { ...colours, robot: colours.start };
  if (robot) drawRobot(ctx, robot, here, itsColours, scale * ratio, livery);
  ctx.restore();
}

function drawDotted(
  ctx: CanvasRenderingContext2D,
  piece: readonly Point[],
  colour: string,
  px: number,
): void {
  ctx.beginPath();
  for (const point of piece) ctx.lineTo(...point);
  ctx.strokeStyle = colour;
  ctx.lineWidth = 5 * px;
  ctx.lineCap = "round";
  ctx.setLineDash([0, 10 * px]);
  ctx.stroke();
  ctx.setLineDash([]);
}
