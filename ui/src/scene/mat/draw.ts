import type { World } from "../../api/model";
import { type Area, areaOf } from "../areas";
import type { Colours } from "../colours";
import { BOX_DRAWINGS, type BoxKind } from "./boxes";
import { GROUNDS } from "./grounds";
import { mixed, type Part } from "./parts";
import { printedParts } from "./prints";

type Ctx = CanvasRenderingContext2D;
export type Ink = (colour: string) => string;
type Box = World["boxes"][number];

/** How much of a print's colour shows: all by day, less at dusk, nothing in high contrast. */
const strengthOf = ({ print }: Colours): number => Number(print) || 0;

/** Whether the floor shows the print of a world instead of tiles. */
export const hasGround = (world: World | null, colours: Colours): boolean =>
  Boolean(world?.ground) && strengthOf(colours) > 0;

/** Draws the ground and all prints of a world. World frame, metres. */
export function drawGround(ctx: Ctx, world: World, colours: Colours): void {
  const strength = strengthOf(colours);
  if (!world.ground || strength === 0) return;
  const ink: Ink = (colour) => mixed(colours.tile, colour, strength);
  const [width, depth] = world.size_m;
  for (const part of GROUNDS[world.ground](width, depth)) drawPart(ctx, part, ink);
}

export function drawPrints(ctx: Ctx, world: World | null, colours: Colours): void {
  const strength = strengthOf(colours);
  if (strength === 0) return;
  const ink: Ink = (colour) => mixed(colours.tile, colour, strength);
  // a world of the world editor omits empty lists
  for (const { print, part } of printedParts(world?.prints ?? [])) {
    inFrame(ctx, areaOf(print), () => drawPart(ctx, part, ink));
  }
}

/** How much of a thing's colour is lost at dusk. */
const DUSK = 0.2;

/** The colour of a part of a thing in a theme; null in high contrast, where things have the two colours of a box. */
export function bodyInk(colours: Colours): Ink | null {
  const strength = strengthOf(colours);
  if (strength === 0) return null;
  return (colour) => (strength < 1 ? mixed(colour, colours.tile, DUSK) : colour);
}

/** Draws the thing that a box is, on top of its shadow. */
export function drawAppearance(ctx: Ctx, box: Box, kind: BoxKind, colours: Colours): void {
  const area = areaOf(box);
  const ink = bodyInk(colours);
  inFrame(ctx, area, () => {
    for (const shape of shapesOf(kind, area)) drawShape(ctx, shape, ink, colours);
  });
}

interface Shape extends Part {
  readonly path: Path2D;
}

/** Shapes of things by kind and size: movable things are drawn in every frame. */
const SHAPES = new Map<string, readonly Shape[]>();
/** Sizes change while a thing is drawn in the world editor. */
const MAX_SHAPES = 300;

function shapesOf(kind: BoxKind, { width, depth }: Area): readonly Shape[] {
  const key = `${kind} ${width} ${depth}`;
  const known = SHAPES.get(key);
  if (known) return known;
  if (SHAPES.size >= MAX_SHAPES) SHAPES.clear();
  const shapes = BOX_DRAWINGS[kind](width, depth, "").map((part) => ({
    ...part,
    path: new Path2D(part.d),
  }));
  SHAPES.set(key, shapes);
  return shapes;
}

function inFrame(ctx: Ctx, { x, y, heading }: Area, draw: () => void): void {
  ctx.save();
  ctx.translate(x, y);
  ctx.rotate((heading * Math.PI) / 180);
  draw();
  ctx.restore();
}

const drawPart = (ctx: Ctx, part: Part, ink: Ink) =>
  drawShape(ctx, { ...part, path: new Path2D(part.d) }, ink);

/** Draws one shape; without `ink` in the two colours of a box, as high contrast needs it. */
function drawShape(ctx: Ctx, part: Shape, ink: Ink | null, colours?: Colours): void {
  const { path } = part;
  if (part.fill) {
    ctx.fillStyle = ink ? ink(part.fill) : (colours?.box ?? part.fill);
    ctx.fill(path);
  }
  if (!part.line) return;
  ctx.strokeStyle = ink ? ink(part.line) : (colours?.boxSide ?? part.line);
  ctx.lineWidth = part.width ?? 0.02;
  ctx.lineJoin = "round";
  ctx.lineCap = "butt";
  ctx.setLineDash([...(part.dash ?? [])]);
  ctx.stroke(path);
  ctx.setLineDash([]);
}
