import type { Language, Texts } from "../../i18n";
import { decimal, metres } from "../../i18n/format";
import type { Colours } from "../colours";
import type { XY } from "../frames";
import { type Size, toScreen, type Viewport } from "../framing/viewport";
import type { Measured, MeasureTool } from "./measure";

type Ctx = CanvasRenderingContext2D;

const ARC_PX = 44;

/** A measurement as text, such as "1,25 m" or "90° à esquerda". */
export function measureText(
  result: Measured,
  { scene }: Pick<Texts, "scene">,
  language: Language,
): string {
  if (result.kind === "distance") return metres(result.metres, language);
  const degrees = `${decimal(Math.abs(result.degrees), 0, language)}°`;
  if (Math.abs(result.degrees) < 0.5) return degrees;
  return result.degrees > 0 ? scene.toLeft({ degrees }) : scene.toRight({ degrees });
}

/** Draws ruler or protractor with its text over everything else; in pixels. */
export function drawMeasure(
  ctx: Ctx,
  tool: MeasureTool,
  points: readonly XY[],
  text: string,
  [viewport, size]: readonly [Viewport, Size],
  colours: Colours,
): void {
  const places = points.map((point) => toScreen(viewport, size, point));
  const [a, b, c] = places;
  if (!a) return;
  ctx.save();
  ctx.lineCap = "round";
  const rays =
    tool === "ruler"
      ? [[a, b]]
      : [
          [a, b],
          [a, c],
        ];
  for (const [from, to] of rays) if (from && to) drawRay(ctx, from, to, colours);
  if (tool === "protractor" && b && c) drawArc(ctx, a, b, c, colours);
  for (const place of places) drawEnd(ctx, place, colours);
  if (text) drawText(ctx, text, textPosition(tool, places), size, colours);
  ctx.restore();
}

function drawRay(ctx: Ctx, from: XY, to: XY, colours: Colours): void {
  ctx.beginPath();
  ctx.moveTo(from.x, from.y);
  ctx.lineTo(to.x, to.y);
  for (const [colour, width] of [
    [colours.tile, 6],
    [colours.start, 3],
  ] as const) {
    ctx.strokeStyle = colour;
    ctx.lineWidth = width;
    ctx.stroke();
  }
}

function drawArc(ctx: Ctx, corner: XY, from: XY, to: XY, colours: Colours): void {
  const begin = Math.atan2(from.y - corner.y, from.x - corner.x);
  const end = Math.atan2(to.y - corner.y, to.x - corner.x);
  const turn = Math.atan2(Math.sin(end - begin), Math.cos(end - begin));
  ctx.beginPath();
  ctx.moveTo(corner.x, corner.y);
  ctx.arc(corner.x, corner.y, ARC_PX, begin, end, turn < 0);
  ctx.closePath();
  ctx.globalAlpha = 0.2;
  ctx.fillStyle = colours.start;
  ctx.fill();
  ctx.globalAlpha = 1;
  ctx.beginPath();
  ctx.arc(corner.x, corner.y, ARC_PX, begin, end, turn < 0);
  ctx.strokeStyle = colours.start;
  ctx.lineWidth = 2;
  ctx.stroke();
  drawTip(ctx, corner, end, Math.sign(turn), colours);
}

/** Draws the arrow head that shows the direction from the first ray to the second. */
function drawTip(ctx: Ctx, corner: XY, angle: number, direction: number, colours: Colours): void {
  ctx.save();
  ctx.translate(corner.x + ARC_PX * Math.cos(angle), corner.y + ARC_PX * Math.sin(angle));
  ctx.rotate(angle + (direction * Math.PI) / 2);
  ctx.beginPath();
  ctx.moveTo(2, 0);
  ctx.lineTo(-9, 6);
  ctx.lineTo(-9, -6);
  ctx.closePath();
  ctx.fillStyle = colours.start;
  ctx.fill();
  ctx.restore();
}

function drawEnd(ctx: Ctx, { x, y }: XY, colours: Colours): void {
  ctx.beginPath();
  ctx.arc(x, y, 6, 0, 2 * Math.PI);
  ctx.fillStyle = colours.tile;
  ctx.fill();
  ctx.strokeStyle = colours.start;
  ctx.lineWidth = 3;
  ctx.stroke();
}

function textPosition(tool: MeasureTool, places: readonly XY[]): XY {
  const [a = { x: 0, y: 0 }, b = a] = places;
  if (tool === "ruler") return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 - 22 };
  return { x: a.x, y: a.y + ARC_PX + 22 };
}

function drawText(ctx: Ctx, text: string, at: XY, size: Size, colours: Colours): void {
  ctx.font = `700 17px ${colours.font}`;
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  const half = ctx.measureText(text).width / 2 + 12;
  const x = Math.min(size.width - half - 4, Math.max(half + 4, at.x));
  const y = Math.min(size.height - 20, Math.max(20, at.y));
  ctx.beginPath();
  ctx.roundRect(x - half, y - 15, 2 * half, 30, 15);
  ctx.fillStyle = colours.tile;
  ctx.fill();
  ctx.strokeStyle = colours.start;
  ctx.lineWidth = 2;
  ctx.stroke();
  ctx.fillStyle = colours.number;
  ctx.fillText(text, x, y + 1);
}
