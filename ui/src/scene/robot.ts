import type { Robot } from "../api/model";
import type { Pose } from "../run/reducer";
import type { Colours } from "./colours";
import { extentOf, hullPath, onHull } from "./hull";
import { type Livery, type LiveryPaint, liveryPaint, patternFrame } from "./livery/livery";
import type { Pattern } from "./livery/patterns";

type Ctx = CanvasRenderingContext2D;

/** Distances from the robot's circle to the start's ring, and to the back and tip of its arrow; metres. */
const RING_M = 0.0675;
const ARROW_M = [0.0975, 0.1975] as const;

/** Minimum length of a drawn robot, in pixels of the screen, so that its heading is visible. */
const MIN_PX = 18;

/** Width of the rim around a livery, which parts it from the path under it; in radii of the robot. */
const RIM = 0.2;

/** Caches: builds the outline of each robot and the path of each pattern once. */
const outlines = new WeakMap<Robot, Path2D>();
const patterns = new WeakMap<Pattern, Path2D>();

function outlineOf(robot: Robot): Path2D {
  const outline = outlines.get(robot) ?? new Path2D(hullPath(robot));
  outlines.set(robot, outline);
  return outline;
}

function shapeOf(pattern: Pattern): Path2D {
  const shape = patterns.get(pattern) ?? new Path2D(pattern.path);
  patterns.set(pattern, shape);
  return shape;
}

/**
 * Draws the robot of a description from above in metres, y up. `pixels` is the number of pixels per metre. A robot
 * without a livery has the colour of the theme.
 */
export function drawRobot(
  ctx: Ctx,
  robot: Robot,
  pose: Pose,
  colours: Colours,
  pixels: number,
  livery: Livery | null = null,
): void {
  ctx.save();
  ctx.translate(pose.x, pose.y);
  ctx.rotate(pose.yaw);
  const enlarged = Math.max(
    1,
    (MIN_PX * (window.devicePixelRatio || 1)) / (pixels * extentOf(robot).length),
  );
  ctx.scale(enlarged, enlarged);
  drawShadow(ctx, robot, pose.yaw, colours, pixels);
  if (livery) drawRim(ctx, robot, colours);
  drawWheels(ctx, robot, colours);
  drawBody(ctx, robot, liveryPaint(livery, colours), colours);
  drawSonars(ctx, robot);
  drawDeck(ctx, robot, colours);
  ctx.restore();
}

/** Draws the shadow, which always falls in the same direction: the light does not turn with the robot. */
function drawShadow(ctx: Ctx, robot: Robot, yaw: number, colours: Colours, pixels: number): void {
  ctx.save();
  ctx.rotate(-yaw);
  ctx.translate(0.07 * robot.radius_m, -0.16 * robot.radius_m);
  ctx.rotate(yaw);
  ctx.shadowColor = colours.shadow;
  ctx.shadowBlur = Math.min(24, pixels * 0.08);
  ctx.fillStyle = colours.shadow;
  ctx.fill(outlineOf(robot));
  ctx.restore();
}

function drawWheels(ctx: Ctx, { wheels }: Robot, colours: Colours): void {
  ctx.fillStyle = colours.wheel;
  for (const { x_m, y_m, radius_m, width_m } of wheels) {
    ctx.beginPath();
    ctx.roundRect(x_m - radius_m, y_m - width_m / 2, 2 * radius_m, width_m, 0.36 * width_m);
    ctx.fill();
  }
}

function drawRim(ctx: Ctx, robot: Robot, colours: Colours): void {
  ctx.strokeStyle = colours.tile;
  ctx.lineWidth = RIM * robot.radius_m;
  ctx.stroke(outlineOf(robot));
}

function drawBody(ctx: Ctx, robot: Robot, { body, pattern }: LiveryPaint, colours: Colours): void {
  const outline = outlineOf(robot);
  ctx.fillStyle = body;
  ctx.fill(outline);
  if (pattern) drawPattern(ctx, robot, pattern);
  ctx.strokeStyle = colours.deck;
  ctx.lineWidth = 0.05 * robot.radius_m;
  ctx.stroke(outline);
}

/** Draws the pattern on the hull, which cuts off what is outside of it. */
function drawPattern(
  ctx: Ctx,
  robot: Robot,
  { drawing, colour }: NonNullable<LiveryPaint["pattern"]>,
): void {
  const { x, unit } = patternFrame(robot);
  ctx.save();
  ctx.clip(outlineOf(robot));
  ctx.translate(x, 0);
  ctx.scale(unit, unit);
  if (drawing.line) {
    ctx.strokeStyle = colour;
    ctx.lineWidth = drawing.line;
    ctx.stroke(shapeOf(drawing));
  } else {
    ctx.fillStyle = colour;
    ctx.fill(shapeOf(drawing));
  }
  ctx.restore();
}

/** Draws the sonars on the drawn hull. The simulated hull, a circle, is larger. */
function drawSonars(ctx: Ctx, robot: Robot): void {
  ctx.fillStyle = "#e9b949";
  for (const { x_m, y_m } of robot.sonars) {
    const { x, y } = onHull(robot, { x: x_m, y: y_m });
    ctx.beginPath();
    ctx.arc(0.9 * x, 0.9 * y, 0.05 * robot.radius_m, 0, 2 * Math.PI);
    ctx.fill();
  }
}

/** Draws the deck with an arrow ahead, as fractions of the hull's length and width, and the laser scanner. */
function drawDeck(ctx: Ctx, robot: Robot, colours: Colours): void {
  const { back, length, width } = extentOf(robot);
  const x = (part: number) => back + part * length;
  ctx.beginPath();
  ctx.roundRect(x(0.15), -0.31 * width, 0.57 * length, 0.62 * width, 0.19 * width);
  ctx.fillStyle = colours.deck;
  ctx.fill();
  if (robot.laser) {
    ctx.beginPath();
    ctx.arc(robot.laser.x_m, robot.laser.y_m, 0.29 * width, 0, 2 * Math.PI);
    ctx.strokeStyle = colours.mark;
    ctx.lineWidth = 0.03 * width;
    ctx.stroke();
  }
  ctx.beginPath();
  ctx.moveTo(x(0.69), 0);
  ctx.lineTo(x(0.35), 0.26 * width);
  ctx.lineTo(x(0.42), 0);
  ctx.lineTo(x(0.35), -0.26 * width);
  ctx.closePath();
  ctx.fillStyle = colours.mark;
  ctx.fill();
}

/** Draws the estimated pose as an outline. */
export function drawBelief(
  ctx: Ctx,
  robot: Robot,
  pose: Pose,
  colours: Colours,
  pixel: number,
): void {
  ctx.save();
  ctx.translate(pose.x, pose.y);
  ctx.rotate(pose.yaw);
  ctx.setLineDash([4 * pixel, 3 * pixel]);
  ctx.strokeStyle = colours.number;
  ctx.lineWidth = 2 * pixel;
  ctx.stroke(outlineOf(robot));
  ctx.beginPath();
  ctx.moveTo(0, 0);
  ctx.lineTo(extentOf(robot).front, 0);
  ctx.stroke();
  ctx.restore();
}

/** Draws the handle that turns the robot at its start, `reach` metres ahead of it. */
export function drawKnob(
  ctx: Ctx,
  robot: Robot,
  reach: number,
  colours: Colours,
  pixel: number,
): void {
  ctx.save();
  ctx.strokeStyle = colours.start;
  ctx.lineWidth = 2 * pixel;
  ctx.beginPath();
  ctx.moveTo(extentOf(robot).front, 0);
  ctx.lineTo(reach, 0);
  ctx.stroke();
  ctx.beginPath();
  ctx.arc(reach, 0, 8 * pixel, 0, 2 * Math.PI);
  ctx.fillStyle = colours.tile;
  ctx.fill();
  ctx.lineWidth = 3 * pixel;
  ctx.stroke();
  ctx.restore();
}

/** Draws the start pose: a ring that encloses the robot. */
export function drawStart(ctx: Ctx, robot: Robot, colours: Colours, pixels: number): void {
  const line = Math.max(2, 0.025 * pixels) / pixels;
  const [base, tip] = ARROW_M.map((distance) => robot.radius_m + distance) as [number, number];
  ctx.save();
  ctx.strokeStyle = colours.start;
  ctx.fillStyle = colours.start;
  ctx.lineWidth = line;
  ctx.beginPath();
  ctx.arc(0, 0, robot.radius_m + RING_M, 0, 2 * Math.PI);
  ctx.setLineDash([0.07, 0.05]);
  ctx.stroke();
  ctx.beginPath();
  ctx.moveTo(tip, 0);
  ctx.lineTo(base, 0.055);
  ctx.lineTo(base, -0.055);
  ctx.closePath();
  ctx.fill();
  ctx.restore();
}
