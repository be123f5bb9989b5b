import type { World } from "../api/model";
import { areaOf, trace } from "./areas";
import type { Colours } from "./colours";
import { drawPictogram, inkOn, isPictured, translationOf } from "./mat/places";
import { edgeOf, paintOf } from "./paints";

type Ctx = CanvasRenderingContext2D;
type Paint = World["floor"][number];

/** Colour that the robot's floor sensor reads on bare floor; it is the same in every theme. */
const BARE_FLOOR = "white";

/** Draws the painted areas of the floor in order, so that later ones cover earlier ones. World frame, metres. */
export function drawPaint(ctx: Ctx, world: World | null, colours: Colours, pixel: number): void {
  ctx.lineWidth = 3 * pixel; // the paint covers the inner half of the line
  for (const areas of layersOf(world?.floor ?? [])) {
    const paint = paintOf(areas[0].color);
    ctx.beginPath();
    for (const area of areas) trace(ctx, areaOf(area));
    ctx.strokeStyle = edgeOf(paint, colours.tile, colours.number) ?? paint;
    ctx.stroke();
    ctx.fillStyle = colours.tile;
    ctx.fill();
    if (areas[0].color === BARE_FLOOR && !world?.ground) continue;
    ctx.fillStyle = paint;
    // full beside a print, which is paler
    ctx.globalAlpha = world?.ground ? 1 : 0.5;
    ctx.fill();
    ctx.globalAlpha = 1;
  }
}

/** Groups consecutive areas of one colour into one shape without seams. */
function layersOf(floor: World["floor"]): [Paint, ...Paint[]][] {
  const layers: [Paint, ...Paint[]][] = [];
  for (const area of floor) {
    const last = layers.at(-1);
    if (last?.[0].color === area.color) last.push(area);
    else layers.push([area]);
  }
  return layers;
}

/**
 * Draws zones as dashed outlines with the name in the centre, legible on any paint. Programs use the name, so it stands
 * there in every language; a translation that the catalogue has stands below it.
 */
export function drawZones(
  ctx: Ctx,
  world: World | null,
  colours: Colours,
  pixel: number,
  withNames = true,
): void {
  const zones = world?.zones ?? [];
  ctx.save();
  for (const zone of zones) {
    ctx.beginPath();
    trace(ctx, areaOf(zone));
    const isField = world !== null && isPictured(world, zone) && inkOn(world, zone) !== null;
    ctx.strokeStyle = isField ? colours.tile : colours.number;
    ctx.lineWidth = isField ? FIELD_EDGE_M : 2 * pixel;
    ctx.stroke();
  }
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  for (const zone of zones) {
    if (world && isPictured(world, zone)) drawPictogram(ctx, world, zone, colours);
    else if (withNames) drawName(ctx, zone, widthBeside(zone, zones), colours, pixel);
  }
  ctx.restore();
}

/** Width of the edge of a painted field with a pictogram. */
const FIELD_EDGE_M = 0.05;

/** Largest width of a name, as a fraction of the zone's width. */
const NAME_PART = 0.8;
const NAME_M = 0.34;
/** Minimum height of legible letters; to reach this height, a name may be wider than its zone. */
const READABLE_PX = 13;
/** Width of the halo around the letters of a name, in the floor's colour, as a fraction of their height. */
const HALO_PART = 0.12;

/** Height of a line of text, as a fraction of the letters' height. */
const LINE_PART = 1.1;

type Zone = World["zones"][number];

/** Maximum width of a name, in metres, without overlapping the name of a neighbouring zone. */
function widthBeside(zone: Zone, zones: readonly Zone[]): number {
  const [x = 0, y = 0] = zone.center;
  const gaps = zones
    .filter((other) => other !== zone && Math.abs((other.center[1] ?? 0) - y) < NAME_M)
    .map((other) => Math.abs((other.center[0] ?? 0) - x));
  return NAME_PART * Math.min(...gaps, Number.MAX_VALUE);
}

function drawName(ctx: Ctx, zone: Zone, maxWidth: number, colours: Colours, pixel: number): void {
  const translation = translationOf(zone.name);
  const lines = translation ? [zone.name, translation] : [zone.name];
  lines.forEach((line, index) => {
    const below = index - (lines.length - 1) / 2;
    drawLine(ctx, line, zone, below, maxWidth, colours, pixel);
  });
}

/** Draws a line of text in a zone's centre, `below` line heights below it. */
function drawLine(
  ctx: Ctx,
  line: string,
  zone: Zone,
  below: number,
  maxWidth: number,
  { font, ink, tile }: Colours,
  pixel: number,
): void {
  const [x = 0, y = 0] = zone.center;
  ctx.save();
  ctx.translate(x, y);
  ctx.scale(0.01, -0.01); // fonts below one pixel render badly
  ctx.font = `${below > 0 ? 400 : 700} ${NAME_M * 100}px ${font}`;
  const width = ctx.measureText(line).width / 100;
  const inside = Math.min(1, (NAME_PART * areaOf(zone).width) / width);
  const readable = Math.min((READABLE_PX * pixel) / NAME_M, maxWidth / width);
  const fit = Math.max(inside, readable);
  ctx.scale(fit, fit);
  const down = below * LINE_PART * NAME_M * 100;
  // no ink contrasts enough with all paints of a theme, but the ink contrasts with the floor
  ctx.strokeStyle = tile;
  ctx.lineWidth = 2 * HALO_PART * NAME_M * 100;
  ctx.lineJoin = "round";
  ctx.strokeText(line, 0, down);
  ctx.fillStyle = ink;
  ctx.fillText(line, 0, down);
  ctx.restore();
}
