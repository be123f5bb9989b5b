import type { Robot, World } from "../../api/model";
import { areaOf, trace, WALL_M } from "../areas";
import type { Colours } from "../colours";
import { drawFlat } from "../floor";
import { roomOf, toStartFrame } from "../frames";
import { drawStart } from "../robot";

type Ctx = CanvasRenderingContext2D;

/** Shadows of fixed bodies: how far they fall to the right and down, and how soft they are, metres. */
const FALL_M = [0.07, 0.1] as const;
const SOFT_M = 0.16;

/** The drawing from above without anything that has a height: the picture on the floor in 3D. */
export function drawGroundTexture(
  world: World | null,
  robot: Robot | null,
  colours: Colours,
  size: number,
): HTMLCanvasElement {
  const { left, right, bottom, top } = roomOf(world);
  const scale = size / Math.max(right - left, top - bottom);
  const canvas = document.createElement("canvas");
  canvas.width = Math.round((right - left) * scale);
  canvas.height = Math.round((top - bottom) * scale);
  const ctx = canvas.getContext("2d");
  if (!ctx) return canvas;
  ctx.scale(scale, -scale);
  ctx.translate(-left, -top);
  // lines are as thick as in a drawing from above at a usual scale
  drawFlat(ctx, world, colours, LINES_PX_PER_M, false);
  if (world) drawShadows(ctx, world, colours, scale);
  if (robot) {
    toStartFrame(ctx, world);
    drawStart(ctx, robot, colours, LINES_PX_PER_M);
  }
  return canvas;
}

const LINES_PX_PER_M = 90;

function drawShadows(ctx: Ctx, world: World, { shadow, print }: Colours, scale: number): void {
  if (!Number(print)) return;
  ctx.save();
  ctx.fillStyle = shadow;
  ctx.strokeStyle = shadow;
  ctx.shadowColor = shadow;
  ctx.shadowBlur = SOFT_M * scale;
  [ctx.shadowOffsetX, ctx.shadowOffsetY] = [FALL_M[0] * scale, FALL_M[1] * scale];
  ctx.lineWidth = WALL_M;
  ctx.beginPath();
  for (const { from, to } of world.walls) {
    ctx.moveTo(from[0] ?? 0, from[1] ?? 0);
    ctx.lineTo(to[0] ?? 0, to[1] ?? 0);
  }
  ctx.stroke();
  ctx.beginPath();
  for (const box of world.boxes) if (!box.movable) trace(ctx, areaOf(box));
  ctx.fill();
  ctx.restore();
}
