import type { World } from "../api/model";
import type { BoxPoses } from "../run/reducer";
import { WALL_M } from "./areas";
import type { Colours } from "./colours";
import { roomOf, startOf, toStart, toStartFrame, toWorld } from "./frames";
import { EDGE, type Size, toScreen, type Viewport } from "./framing/viewport";
import { drawPaint, drawZones } from "./ground";
import { drawAppearance, drawGround, drawPrints, hasGround } from "./mat/draw";
import { drawPlates } from "./mat/places";

/** Height of the world selector over the upper left corner, pixels. */
const WORLD_CHOICE = 68;

/** All functions here draw in the world frame, in metres, y up. */
type Ctx = CanvasRenderingContext2D;

/** Draws the room and its objects; without the movable boxes if the caller draws them separately. */
export function drawFloor(
  ctx: Ctx,
  world: World | null,
  colours: Colours,
  scale: number,
  withMovable = true,
): void {
  drawFlat(ctx, world, colours, scale);
  for (const box of world?.boxes ?? []) if (withMovable || !box.movable) drawBox(ctx, box, colours);
  drawWalls(ctx, world, colours);
  if (world) drawPlates(ctx, world, colours, 1 / scale);
}

/** Draws what is flat: ground, prints, tiles, paint and places. */
export function drawFlat(
  ctx: Ctx,
  world: World | null,
  colours: Colours,
  scale: number,
  withNames = true,
): void {
  const room = roomOf(world);
  ctx.save();
  ctx.beginPath();
  ctx.rect(room.left, room.bottom, room.right - room.left, room.top - room.bottom);
  ctx.fillStyle = colours.tile;
  ctx.fill();
  ctx.clip();
  if (world) drawGround(ctx, world, colours);
  drawPrints(ctx, world, colours);
  drawTiles(ctx, world, colours, scale);
  ctx.restore();
  drawPaint(ctx, world, colours, 1 / scale);
  drawZones(ctx, world, colours, 1 / scale, withNames);
}

/** Range of the start frame that the room covers, metres. */
function spanOf(world: World | null): [left: number, right: number, bottom: number, top: number] {
  const room = roomOf(world);
  const start = startOf(world);
  const corners = [room.left, room.right].flatMap((x) =>
    [room.bottom, room.top].map((y) => toStart(start, x, y)),
  );
  const xs = corners.map((corner) => corner.x);
  const ys = corners.map((corner) => corner.y);
  return [
    Math.floor(Math.min(...xs)),
    Math.ceil(Math.max(...xs)),
    Math.floor(Math.min(...ys)),
    Math.ceil(Math.max(...ys)),
  ];
}

/** The metre grid is quieter than a print. */
const GRID_ON_PRINT = 0.45;

function drawTiles(ctx: Ctx, world: World | null, colours: Colours, scale: number): void {
  const [left, right, bottom, top] = spanOf(world);
  toStartFrame(ctx, world);
  ctx.fillStyle = colours.otherTile;
  const isPrinted = hasGround(world, colours);
  for (let x = left; x < right && !isPrinted; x++) {
    for (let y = bottom; y < top; y++) if ((x + y) % 2 !== 0) ctx.fillRect(x, y, 1, 1);
  }
  ctx.strokeStyle = colours.line;
  if (isPrinted) ctx.globalAlpha = GRID_ON_PRINT;
  ctx.lineWidth = 1 / scale;
  ctx.beginPath();
  for (let x = left; x <= right; x++) {
    ctx.moveTo(x, bottom);
    ctx.lineTo(x, top);
  }
  for (let y = bottom; y <= top; y++) {
    ctx.moveTo(left, y);
    ctx.lineTo(right, y);
  }
  ctx.stroke();
}

function drawWalls(ctx: Ctx, world: World | null, colours: Colours): void {
  ctx.strokeStyle = colours.wall;
  ctx.lineCap = "round";
  ctx.lineJoin = "round";
  ctx.lineWidth = WALL_M;
  ctx.beginPath();
  for (const wall of world?.walls ?? []) {
    ctx.moveTo(wall.from[0] ?? 0, wall.from[1] ?? 0);
    ctx.lineTo(wall.to[0] ?? 0, wall.to[1] ?? 0);
  }
  ctx.stroke();
}

function drawBox(ctx: Ctx, box: World["boxes"][number], colours: Colours): void {
  drawBody(ctx, box, colours);
  if (box.kind) drawAppearance(ctx, box, box.kind, colours);
}

function drawBody(ctx: Ctx, box: World["boxes"][number], colours: Colours): void {
  const [width = 0, depth = 0] = box.size;
  ctx.save();
  ctx.translate(box.center[0] ?? 0, box.center[1] ?? 0);
  ctx.rotate((box.heading_deg * Math.PI) / 180);
  ctx.beginPath();
  ctx.roundRect(-width / 2, -depth / 2, width, depth, 0.05);
  ctx.save();
  ctx.shadowColor = colours.shadow;
  ctx.shadowBlur = 8;
  ctx.shadowOffsetX = 4;
  ctx.shadowOffsetY = 5;
  ctx.fillStyle = colours.box;
  ctx.fill();
  ctx.restore();
  ctx.strokeStyle = colours.boxSide;
  ctx.lineWidth = 0.04;
  ctx.stroke();
  ctx.lineWidth = 0.02;
  drawLid(ctx, width / 2 - 0.1, depth / 2 - 0.1, box.movable);
  ctx.restore();
}

/** A movable box is drawn as a crate with a cross, a fixed one as a chest with a bar. */
function drawLid(ctx: Ctx, right: number, top: number, movable: boolean): void {
  if (right <= 0 || top <= 0) return;
  ctx.beginPath();
  for (const sign of movable ? [-1, 1] : [0]) {
    ctx.moveTo(-right, -sign * top);
    ctx.lineTo(right, sign * top);
  }
  ctx.stroke();
}

export function drawMovableBoxes(
  ctx: Ctx,
  world: World | null,
  poses: BoxPoses,
  colours: Colours,
): void {
  world?.boxes.forEach((box, index) => {
    if (!box.movable) return;
    const [x, y, yaw] = poses[index] ?? [];
    if (x === undefined || y === undefined || yaw === undefined) drawBox(ctx, box, colours);
    else drawBox(ctx, { ...box, center: [x, y], heading_deg: (yaw * 180) / Math.PI }, colours);
  });
}

/** Draws the numbers of the metre grid along the edges, in pixels, over everything else. */
export function drawRulers(
  ctx: Ctx,
  world: World | null,
  viewport: Viewport,
  size: Size,
  colours: Colours,
): void {
  const start = startOf(world);
  const [left, right, bottom, top] = spanOf(world);
  const every = viewport.scale < 34 ? 2 : 1;
  ctx.font = `600 13px ${colours.font}`;
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  const label = (metre: number, from: [number, number], to: [number, number]) => {
    if (metre % every !== 0) return;
    const a = toScreen(viewport, size, toWorld(start, ...from));
    const b = toScreen(viewport, size, toWorld(start, ...to));
    const place = edgePoint(a, b, size);
    if (place) number(ctx, metre, place, colours);
  };
  for (let x = left; x <= right; x++) label(x, [x, bottom], [x, top]);
  for (let y = bottom; y <= top; y++) label(y, [left, y], [right, y]);
}

interface ScreenPoint {
  x: number;
  y: number;
}

/** The point at which a grid line crosses the lower edge; for a horizontal line, the left edge. */
function edgePoint(a: ScreenPoint, b: ScreenPoint, size: Size): ScreenPoint | null {
  const dx = b.x - a.x;
  const dy = b.y - a.y;
  if (Math.abs(dy) >= Math.abs(dx)) {
    const y = size.height - EDGE.bottom / 2;
    const x = a.x + (dx * (y - a.y)) / dy;
    return x > EDGE.left && x < size.width - EDGE.right ? { x, y } : null;
  }
  const x = EDGE.left / 2;
  const y = a.y + (dy * (x - a.x)) / dx;
  return y > WORLD_CHOICE && y < size.height - EDGE.bottom ? { x, y } : null;
}

function number(ctx: Ctx, metre: number, { x, y }: ScreenPoint, colours: Colours): void {
  const text = metre < 0 ? `\u2212${-metre}` : metre === 0 ? "0" : `${metre}`;
  const width = ctx.measureText(text).width + 10;
  ctx.fillStyle = colours.tile;
  ctx.beginPath();
  ctx.roundRect(x - width / 2, y - 9, width, 18, 9);
  ctx.fill();
  ctx.fillStyle = colours.number;
  ctx.fillText(text, x, y + 0.5);
}
