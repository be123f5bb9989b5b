import type { Pose } from "../run/reducer";
import type { Palette } from "./palette";

type Ctx = CanvasRenderingContext2D;

/** Pioneer 3-DX from its data sheet: 455 x 381 mm, wheels of 195 mm, front along +x. Metres. */
const LENGTH = 0.455;
const WIDTH = 0.381;
const WHEEL = { length: 0.195, width: 0.05, x: 0.03, y: 0.165 };
const SONARS = [-75, -50, -30, -10, 10, 30, 50, 75];

/** Draws the robot from above in metres, y up. `pixels` is the number of pixels per metre. */
export function drawRobot(ctx: Ctx, pose: Pose, palette: Palette, pixels: number): void {
  ctx.save();
  ctx.translate(pose.x, pose.y);
  ctx.rotate(pose.yaw);
  drawShadow(ctx, pose.yaw, palette, pixels);
  drawWheels(ctx, palette);
  drawBody(ctx, palette);
  drawSonars(ctx);
  drawDeck(ctx, palette);
  ctx.restore();
}

function outline(ctx: Ctx, grow = 0): void {
  const front = LENGTH / 2 + grow;
  const back = -LENGTH / 2 - grow;
  const side = WIDTH / 2 - 0.03 + grow;
  ctx.beginPath();
  ctx.moveTo(back + 0.07, -side);
  ctx.lineTo(front - 0.13, -side);
  ctx.quadraticCurveTo(front, -side * 0.72, front, 0);
  ctx.quadraticCurveTo(front, side * 0.72, front - 0.13, side);
  ctx.lineTo(back + 0.07, side);
  ctx.quadraticCurveTo(back, side, back, side * 0.45);
  ctx.lineTo(back, -side * 0.45);
  ctx.quadraticCurveTo(back, -side, back + 0.07, -side);
  ctx.closePath();
}

/** The light does not turn with the robot, so the shadow always falls in the same direction. */
function drawShadow(ctx: Ctx, yaw: number, palette: Palette, pixels: number): void {
  ctx.save();
  ctx.rotate(-yaw);
  ctx.translate(0.015, -0.035);
  ctx.rotate(yaw);
  ctx.shadowColor = palette.shadow;
  ctx.shadowBlur = Math.min(24, pixels * 0.08);
  ctx.fillStyle = palette.shadow;
  outline(ctx, 0.01);
  ctx.fill();
  ctx.restore();
}

function drawWheels(ctx: Ctx, palette: Palette): void {
  ctx.fillStyle = palette.wheel;
  for (const side of [-1, 1]) {
    ctx.beginPath();
    ctx.roundRect(
      WHEEL.x - WHEEL.length / 2,
      side * WHEEL.y - WHEEL.width / 2,
      WHEEL.length,
      WHEEL.width,
      0.018,
    );
    ctx.fill();
  }
}

function drawBody(ctx: Ctx, palette: Palette): void {
  outline(ctx);
  ctx.fillStyle = palette.robot;
  ctx.fill();
  ctx.strokeStyle = palette.deck;
  ctx.lineWidth = 0.012;
  ctx.stroke();
}

function drawSonars(ctx: Ctx): void {
  ctx.fillStyle = "#e9b949";
  for (const angle of SONARS) {
    const turn = (angle * Math.PI) / 180;
    ctx.beginPath();
    ctx.arc(0.035 + Math.cos(turn) * 0.168, Math.sin(turn) * 0.138, 0.011, 0, 2 * Math.PI);
    ctx.fill();
  }
}

function drawDeck(ctx: Ctx, palette: Palette): void {
  ctx.beginPath();
  ctx.roundRect(-0.16, -0.1, 0.26, 0.2, 0.06);
  ctx.fillStyle = palette.deck;
  ctx.fill();
  ctx.beginPath();
  ctx.moveTo(0.085, 0);
  ctx.lineTo(-0.07, 0.085);
  ctx.lineTo(-0.035, 0);
  ctx.lineTo(-0.07, -0.085);
  ctx.closePath();
  ctx.fillStyle = palette.mark;
  ctx.fill();
}

/** Draws the believed pose as an outline. */
export function drawBelief(ctx: Ctx, pose: Pose, palette: Palette, pixel: number): void {
  ctx.save();
  ctx.translate(pose.x, pose.y);
  ctx.rotate(pose.yaw);
  outline(ctx);
  ctx.moveTo(0, 0);
  ctx.lineTo(LENGTH / 2, 0);
  ctx.setLineDash([4 * pixel, 3 * pixel]);
  ctx.strokeStyle = palette.number;
  ctx.lineWidth = 2 * pixel;
  ctx.stroke();
  ctx.restore();
}

/** Draws the handle that turns the robot at its start, `reach` metres ahead of it. */
export function drawKnob(ctx: Ctx, reach: number, palette: Palette, pixel: number): void {
  ctx.save();
  ctx.strokeStyle = palette.start;
  ctx.lineWidth = 2 * pixel;
  ctx.beginPath();
  ctx.moveTo(LENGTH / 2, 0);
  ctx.lineTo(reach, 0);
  ctx.stroke();
  ctx.beginPath();
  ctx.arc(reach, 0, 8 * pixel, 0, 2 * Math.PI);
  ctx.fillStyle = palette.tile;
  ctx.fill();
  ctx.lineWidth = 3 * pixel;
  ctx.stroke();
  ctx.restore();
}

/** Draws the start pose. */
export function drawStart(ctx: Ctx, palette: Palette, pixels: number): void {
  const line = Math.max(2, 0.025 * pixels) / pixels;
  ctx.save();
  ctx.strokeStyle = palette.start;
  ctx.fillStyle = palette.start;
  ctx.lineWidth = line;
  ctx.beginPath();
  ctx.arc(0, 0, 0.29, 0, 2 * Math.PI);
  ctx.setLineDash([0.07, 0.05]);
  ctx.stroke();
  ctx.beginPath();
  ctx.moveTo(0.42, 0);
  ctx.lineTo(0.32, 0.055);
  ctx.lineTo(0.32, -0.055);
  ctx.closePath();
  ctx.fill();
  ctx.restore();
}
