import type { Laser, Robot, Sonar } from "../api/model";
import type { Colours } from "./colours";

type Ctx = CanvasRenderingContext2D;

/** Half of the opening angle of a drawn sonar cone, degrees. */
export const CONE_DEG = 7;
/** If a distance is less than this below the sonar's range, the sonar detects nothing. */
export const FAR_M = 0.05;

export interface Measurements {
  readonly sonar: readonly number[] | null;
  readonly lidar: readonly number[] | null;
}

/** Draws the measured distances around the robot at the origin; metres. */
export function drawRanges(
  ctx: Ctx,
  robot: Robot,
  ranges: Measurements,
  colours: Colours,
  pixel: number,
): void {
  const { laser, sonars, sonar_range_m } = robot;
  ctx.save();
  if (ranges.lidar && laser) drawLidar(ctx, laser, ranges.lidar, colours, pixel);
  ranges.sonar?.forEach((metres, index) => {
    const sonar = sonars[index];
    const isNear = metres < sonar_range_m - FAR_M;
    if (sonar) drawCone(ctx, sonar, [metres, isNear], colours, pixel);
  });
  ctx.restore();
}

/** Draws one beam per degree over the scanner's field, from the right to the left. */
function drawLidar(
  ctx: Ctx,
  { x_m, y_m, field_deg }: Laser,
  beams: readonly number[],
  colours: Colours,
  pixel: number,
): void {
  ctx.beginPath();
  if (field_deg < 360) ctx.moveTo(x_m, y_m);
  beams.forEach((metres, degree) => {
    const angle = ((degree - field_deg / 2) * Math.PI) / 180;
    ctx.lineTo(x_m + metres * Math.cos(angle), y_m + metres * Math.sin(angle));
  });
  ctx.closePath();
  ctx.globalAlpha = 0.1;
  ctx.fillStyle = colours.start;
  ctx.fill();
  ctx.globalAlpha = 0.55;
  ctx.strokeStyle = colours.start;
  ctx.lineWidth = 1.5 * pixel;
  ctx.stroke();
}

function drawCone(
  ctx: Ctx,
  { x_m: x, y_m: y, angle_rad: angle }: Sonar,
  [metres, near]: readonly [number, boolean],
  colours: Colours,
  pixel: number,
): void {
  const half = (CONE_DEG * Math.PI) / 180;
  ctx.beginPath();
  ctx.moveTo(x, y);
  ctx.arc(x, y, metres, angle - half, angle + half);
  ctx.closePath();
  ctx.globalAlpha = near ? 0.13 : 0.04;
  ctx.fillStyle = colours.path;
  ctx.fill();
  if (!near) return;
  ctx.beginPath();
  ctx.arc(x, y, metres, angle - half, angle + half);
  ctx.globalAlpha = 0.9;
  ctx.strokeStyle = colours.path;
  ctx.lineWidth = 3 * pixel;
  ctx.stroke();
}
