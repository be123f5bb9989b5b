import type { Robot, World } from "../../api/model";
import { readColours } from "../../scene/colours";
import { drawFloor, drawRulers } from "../../scene/floor";
import type { XY } from "../../scene/frames";
import { wholeRoom } from "../../scene/framing/content_bounds";
import { clampScale, type Size, type Viewport, viewportFor } from "../../scene/framing/viewport";
import type { Livery } from "../../scene/livery/livery";
import { drawRobot, drawStart } from "../../scene/robot";

/** Viewport and size of the board. */
export interface View {
  readonly size: Size;
  readonly viewport: Viewport;
}

export const wholeView = (world: World, size: Size): View => ({
  size,
  viewport: viewportFor(wholeRoom(world), size),
});

export function floorPoint({ viewport, size }: View, x: number, y: number): XY {
  return {
    x: viewport.x + (x - size.width / 2) / viewport.scale,
    y: viewport.y - (y - size.height / 2) / viewport.scale,
  };
}

/** Zooms; the floor under the point `x`, `y` of the board stays in place. */
export function zoomed(view: View, factor: number, x: number, y: number): View {
  const held = floorPoint(view, x, y);
  const scale = clampScale(view.viewport.scale * factor);
  const part = view.viewport.scale / scale;
  const viewport = {
    x: held.x + (view.viewport.x - held.x) * part,
    y: held.y + (view.viewport.y - held.y) * part,
    scale,
  };
  return { ...view, viewport };
}

export function panned(view: View, dx: number, dy: number): View {
  const { x, y, scale } = view.viewport;
  return { ...view, viewport: { x: x - dx / scale, y: y + dy / scale, scale } };
}

/** Draws the floor with the scene's functions; tiles and numbers are in the start frame, as in blocks. */
export function paintBoard(
  canvas: HTMLCanvasElement,
  world: World,
  robot: Robot | null,
  livery: Livery | null,
  view: View,
): void {
  const ctx = canvas.getContext("2d");
  if (!ctx) return;
  const colours = readColours();
  fitTo(canvas, view.size);
  const { size, viewport } = view;
  const ratio = canvas.width / size.width;
  ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
  ctx.fillStyle = colours.outside;
  ctx.fillRect(0, 0, size.width, size.height);
  ctx.save();
  ctx.translate(size.width / 2, size.height / 2);
  ctx.scale(viewport.scale, -viewport.scale);
  ctx.translate(-viewport.x, -viewport.y);
  drawFloor(ctx, world, colours, viewport.scale);
  if (robot) {
    toStart(ctx, world);
    drawStart(ctx, robot, colours, viewport.scale * ratio);
    drawRobot(ctx, robot, { x: 0, y: 0, yaw: 0 }, colours, viewport.scale * ratio, livery);
  }
  ctx.restore();
  drawRulers(ctx, world, viewport, size, colours);
}

function toStart(ctx: CanvasRenderingContext2D, { start }: World): void {
  ctx.translate(start.x_m, start.y_m);
  ctx.rotate((start.heading_deg * Math.PI) / 180);
}

function fitTo(canvas: HTMLCanvasElement, { width, height }: Size): void {
  const ratio = window.devicePixelRatio || 1;
  const [wide, high] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width === wide && canvas.height === high) return;
  canvas.width = wide;
  canvas.height = high;
}
