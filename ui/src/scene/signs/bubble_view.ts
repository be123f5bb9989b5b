import type { Colours } from "../colours";
import type { XY } from "../frames";
import type { Size } from "../framing/viewport";
import { bubbleLines, characters, isRightToLeft } from "./bubble_lines";

type Ctx = CanvasRenderingContext2D;

/** Minimum distance of a sign from the upper and the right edge, in pixels: controls cover the floor there. */
const TOP_PX = 76;
const RIGHT_PX = 66;
const EDGE_PX = 4;
/** On a lower floor a bubble has one line. */
const LOW_PX = 240;

const FONT_PX = 18;
const LINE_PX = 23;
const PADDING_PX = { x: 14, y: 8 };
const TAIL_PX = { length: 12, halfWidth: 8 };

const NAME_FONT_PX = 14;
export const NAME_HEIGHT_PX = 22;
export const NAME_MAX_PX = 150;

/** Where a name is, seen from its robot. */
export type NameSide = "below" | "above" | "left" | "right";

/** Where the robot stands on the canvas: its centre, and the radius around it that stays free, in pixels. */
export interface RobotPlace {
  readonly at: XY;
  readonly reach: number;
  readonly size: Size;
}

/** Draws a speech bubble beside the robot, inside of the visible floor. `grown` is its size, 0 to 1. */
export function drawBubble(
  ctx: Ctx,
  text: string,
  place: RobotPlace,
  grown: number,
  colours: Colours,
): void {
  const lines = bubbleLines(text, place.size.height < LOW_PX ? 1 : 2);
  ctx.save();
  ctx.font = `600 ${FONT_PX}px ${colours.font}`;
  ctx.direction = isRightToLeft(text) ? "rtl" : "ltr";
  const width = Math.max(40, ...lines.map((line) => ctx.measureText(line).width));
  const box = boxAt(place, {
    width: width + 2 * PADDING_PX.x,
    height: lines.length * LINE_PX + 2 * PADDING_PX.y,
  });
  growFrom(ctx, place.at, grown);
  outline(ctx, box, place);
  ctx.fillStyle = colours.tile;
  ctx.fill();
  ctx.strokeStyle = colours.ink;
  ctx.lineWidth = 2.5;
  ctx.stroke();
  ctx.fillStyle = colours.ink;
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  for (const [index, line] of lines.entries())
    ctx.fillText(line, box.x, box.top + PADDING_PX.y + (index + 0.5) * LINE_PX + 1);
  ctx.restore();
}

/** Draws the words of a beep on a dark plate above the robot. */
export function drawPlate(ctx: Ctx, text: string, place: RobotPlace, colours: Colours): void {
  ctx.save();
  ctx.font = `700 20px ${colours.font}`;
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  const height = 36;
  const box = boxAt(place, { width: ctx.measureText(text).width + 28, height }, 0);
  ctx.beginPath();
  ctx.roundRect(box.x - box.width / 2, box.top, box.width, height, height / 2);
  ctx.fillStyle = colours.ink;
  ctx.fill();
  ctx.strokeStyle = colours.tile;
  ctx.lineWidth = 2;
  ctx.stroke();
  ctx.fillStyle = colours.tile;
  ctx.fillText(text, box.x, box.top + height / 2 + 1);
  ctx.restore();
}

/** Draws the robot's name at its side. */
export function drawName(
  ctx: Ctx,
  name: string,
  place: RobotPlace,
  side: NameSide,
  colours: Colours,
): void {
  ctx.save();
  ctx.font = `600 ${NAME_FONT_PX}px ${colours.font}`;
  ctx.direction = isRightToLeft(name) ? "rtl" : "ltr";
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  const text = shortened(ctx, name);
  const half = ctx.measureText(text).width / 2 + 8;
  const { x, y } = nameAt(place, side, half);
  ctx.beginPath();
  ctx.roundRect(x - half, y - NAME_HEIGHT_PX / 2, 2 * half, NAME_HEIGHT_PX, NAME_HEIGHT_PX / 2);
  ctx.globalAlpha = 0.9;
  ctx.fillStyle = colours.tile;
  ctx.fill();
  ctx.globalAlpha = 1;
  ctx.fillStyle = colours.ink;
  ctx.fillText(text, x, y + 1);
  ctx.restore();
}

/** The middle of a name. Without room on its side: below under the controls, above at the lower edge. */
export function nameAt(place: RobotPlace, side: NameSide, half: number): XY {
  const { at, reach, size } = place;
  const [first, last] = [half + EDGE_PX, size.width - half - rightOf(2 * half, size)];
  const beside = at.x + (side === "left" ? -1 : 1) * (reach + half + 2);
  const isBeside = side === "left" || side === "right";
  if (isBeside && beside >= first && beside <= last && at.y >= topOf(size))
    return { x: beside, y: at.y };
  return { x: within(at.x, first, last), y: heightOf(place, side === "above") };
}

function heightOf({ at, reach, size }: RobotPlace, isAbove: boolean): number {
  const away = reach + NAME_HEIGHT_PX / 2 + 2;
  const isFreeAbove = at.y - away - NAME_HEIGHT_PX / 2 >= topOf(size);
  const isFreeBelow = at.y + away + NAME_HEIGHT_PX < size.height;
  return at.y + (isFreeBelow && !(isAbove && isFreeAbove) ? away : -away);
}

function shortened(ctx: Ctx, name: string): string {
  if (ctx.measureText(name).width <= NAME_MAX_PX) return name;
  const all = characters(name);
  while (all.length > 1 && ctx.measureText(`${all.join("")}…`).width > NAME_MAX_PX) all.pop();
  return `${all.join("").trimEnd()}…`;
}

export interface Bounds extends Size {
  /** The middle. */
  readonly x: number;
  readonly top: number;
}

/** Space to the right of a sign: the floor's tools, where the sign has room beside them. */
function rightOf(width: number, size: Size): number {
  return width + EDGE_PX + RIGHT_PX <= size.width ? RIGHT_PX : EDGE_PX;
}

/** Lower edge of the controls over the floor. */
const topOf = (size: Size) => Math.min(TOP_PX, size.height / 4);

/** The place of a sign, inside of the floor: above the robot, or below it where controls cover the floor. */
export function boxAt({ at, reach, size }: RobotPlace, box: Size, tail = TAIL_PX.length): Bounds {
  const { width, height } = box;
  const right = rightOf(width, size);
  const x = within(at.x, EDGE_PX + width / 2, size.width - right - width / 2);
  const above = at.y - reach - tail - height;
  const best = above < topOf(size) ? at.y + reach + tail : above;
  return { x, width, height, top: within(best, EDGE_PX, size.height - EDGE_PX - height) };
}

const within = (value: number, min: number, max: number) => Math.max(min, Math.min(max, value));

/** Scales around the robot, from which the bubble grows. */
function growFrom(ctx: Ctx, { x, y }: XY, grown: number): void {
  const scale = 0.6 + 0.4 * grown;
  ctx.translate(x, y);
  ctx.scale(scale, scale);
  ctx.translate(-x, -y);
}

/** The outline of a bubble with a tail that points to the robot. */
function outline(ctx: Ctx, { x, top, width, height }: Bounds, { at, reach }: RobotPlace): void {
  const [left, right, bottom] = [x - width / 2, x + width / 2, top + height];
  const corner = Math.min(14, height / 2);
  const { halfWidth } = TAIL_PX;
  const base = within(at.x, left + corner + halfWidth, right - corner - halfWidth);
  const isAbove = bottom <= at.y;
  const tip = { x: at.x, y: isAbove ? at.y - 0.8 * reach : at.y + 0.8 * reach };
  ctx.beginPath();
  ctx.moveTo(left + corner, top);
  if (!isAbove) tail(ctx, base - halfWidth, base + halfWidth, top, tip);
  ctx.lineTo(right - corner, top);
  ctx.arcTo(right, top, right, bottom, corner);
  ctx.arcTo(right, bottom, left, bottom, corner);
  if (isAbove) tail(ctx, base + halfWidth, base - halfWidth, bottom, tip);
  ctx.lineTo(left + corner, bottom);
  ctx.arcTo(left, bottom, left, top, corner);
  ctx.arcTo(left, top, right, top, corner);
  ctx.closePath();
  ctx.lineJoin = "round";
}

function tail(ctx: Ctx, from: number, to: number, y: number, tip: XY): void {
  ctx.lineTo(from, y);
  ctx.lineTo(tip.x, tip.y);
  ctx.lineTo(to, y);
}
