import type { Palette } from "./palette";

type Ctx = CanvasRenderingContext2D;

/** Direction of each sonar of the Pioneer 3-DX by its index, in degrees; each is mounted on the hull's rim. */
export const SONAR_DEG = [
  90, 50, 30, 10, -10, -30, -50, -90, -90, -130, -150, -170, 170, 150, 130, 90,
] as const;
const HULL_M = 0.2225;

/** Half of the opening angle of a drawn sonar cone, degrees. */
const CONE_DEG = 7;
/** A distance above this means that the sonar detects nothing. */
const FAR_M = 4.95;

export interface Measurements {
  readonly sonar: readonly number[] | null;
  readonly lidar: readonly number[] | null;
}

/** Draws the measured distances around the robot at the origin; metres. */
export function drawRanges(ctx: Ctx, ranges: Measurements, palette: Palette, pixel: number): void {
  ctx.save();
  if (ranges.lidar) drawLidar(ctx, ranges.lidar, palette, pixel);
  ranges.sonar?.forEach((metres, index) => {
    const angle = SONAR_DEG[index];
    if (angle !== undefined) drawCone(ctx, angle, metres, palette, pixel);
  });
  ctx.restore();
}

/** Draws one beam per degree from -90 (right) to 90 (left). */
function drawLidar(ctx: Ctx, beams: readonly number[], palette: Palette, pixel: number): void {
  ctx.beginPath();
  ctx.moveTo(0, 0);
  beams.forEach((metres, degree) => {
    const angle = ((degree - 90) * Math.PI) / 180;
    ctx.lineTo(metres * Math.cos(angle), metres * Math.sin(angle));
  });
  ctx.closePath();
  ctx.globalAlpha = 0.1;
  ctx.fillStyle = palette.start;
  ctx.fill();
  ctx.globalAlpha = 0.55;
  ctx.strokeStyle = palette.start;
  ctx.lineWidth = 1.5 * pixel;
  ctx.stroke();
}

function drawCone(
  ctx: Ctx,
  degrees: number,
  metres: number,
  palette: Palette,
  pixel: number,
): void {
  const angle = (degrees * Math.PI) / 180;
  const half = (CONE_DEG * Math.PI) / 180;
  const [x, y] = [HULL_M * Math.cos(angle), HULL_M * Math.sin(angle)];
  const near = metres < FAR_M;
  ctx.beginPath();
  ctx.moveTo(x, y);
  ctx.arc(x, y, metres, angle - half, angle + half);
  ctx.closePath();
  ctx.globalAlpha = near ? 0.13 : 0.04;
  ctx.fillStyle = palette.path;
  ctx.fill();
  if (!near) return;
  ctx.beginPath();
  ctx.arc(x, y, metres, angle - half, angle + half);
  ctx.globalAlpha = 0.9;
  ctx.strokeStyle = palette.path;
  ctx.lineWidth = 3 * pixel;
  ctx.stroke();
}
