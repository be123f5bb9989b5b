import type { Robot, World } from "../../api/model";
import { type Camera, cameraFor, clampScale, type Size } from "../../scene/camera";
import { drawFloor, drawRulers } from "../../scene/floor";
import type { XY } from "../../scene/frames";
import { type Palette, readPalette } from "../../scene/palette";
import { drawRobot, drawStart } from "../../scene/robot";
import { wholeRoom } from "../../scene/subject";

/** Camera and size of the board: where the floor is drawn. */
export interface View {
  readonly size: Size;
  readonly camera: Camera;
}

export const wholeView = (world: World, size: Size): View => ({
  size,
  camera: cameraFor(wholeRoom(world), size),
});

export function floorPoint({ camera, size }: View, x: number, y: number): XY {
  return {
    x: camera.x + (x - size.width / 2) / camera.scale,
    y: camera.y - (y - size.height / 2) / camera.scale,
  };
}

/** Zooms about a fixed point of the board. */
export function zoomed(view: View, factor: number, x: number, y: number): View {
  const held = floorPoint(view, x, y);
  const scale = clampScale(view.camera.scale * factor);
  const part = view.camera.scale / scale;
  const camera = {
    x: held.x + (view.camera.x - held.x) * part,
    y: held.y + (view.camera.y - held.y) * part,
    scale,
  };
  return { ...view, camera };
}

export function panned(view: View, dx: number, dy: number): View {
  const { x, y, scale } = view.camera;
  return { ...view, camera: { x: x - dx / scale, y: y + dy / scale, scale } };
}

/** Draws the floor with the scene's functions; tiles and numbers count from the start, as blocks do. */
export function paintBoard(
  canvas: HTMLCanvasElement,
  world: World,
  robot: Robot | null,
  view: View,
): void {
  const ctx = canvas.getContext("2d");
  if (!ctx) return;
  const palette = readPalette();
  fitTo(canvas, view.size);
  const { size, camera } = view;
  const ratio = canvas.width / size.width;
  ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
  ctx.fillStyle = palette.outside;
  ctx.fillRect(0, 0, size.width, size.height);
  ctx.save();
  ctx.translate(size.width / 2, size.height / 2);
  ctx.scale(camera.scale, -camera.scale);
  ctx.translate(-camera.x, -camera.y);
  drawFloor(ctx, world, palette, camera.scale);
  if (robot) drawStanding(ctx, world, robot, palette, camera.scale * ratio);
  ctx.restore();
  drawRulers(ctx, world, camera, size, palette);
}

function drawStanding(
  ctx: CanvasRenderingContext2D,
  { start }: World,
  robot: Robot,
  palette: Palette,
  pixels: number,
): void {
  ctx.translate(start.x_m, start.y_m);
  ctx.rotate((start.heading_deg * Math.PI) / 180);
  drawStart(ctx, robot, palette, pixels);
  drawRobot(ctx, robot, { x: 0, y: 0, yaw: 0 }, palette, pixels);
}

function fitTo(canvas: HTMLCanvasElement, { width, height }: Size): void {
  const ratio = window.devicePixelRatio || 1;
  const [wide, high] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width === wide && canvas.height === high) return;
  canvas.width = wide;
  canvas.height = high;
}
