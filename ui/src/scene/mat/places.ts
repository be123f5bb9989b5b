import type { World } from "../../api/model";
import { texts } from "../../i18n";
import { type Area, areaOf, contains, WALL_M } from "../areas";
import type { Colours } from "../colours";
import { roomOf, type XY } from "../frames";
import { contrast, paintOf } from "../paints";
import { PICTOGRAM_SIZE, pictogramOf } from "./pictograms";

type Ctx = CanvasRenderingContext2D;
type Zone = World["zones"][number];

/** Side of a pictogram as a part of its field's shorter side. */
export const PICTOGRAM_PART = 0.62;
const NAME_M = 0.2;
const READABLE_PX = 13;
const GAP_M = 0.06;

/** Whether a place has a pictogram on its field and its name on a plate beside it. */
export const isPictured = (world: World, zone: Zone): boolean =>
  Boolean(world.ground) && pictogramOf(zone.name) !== null;

/** Draws the pictogram of a place on its field. World frame, metres. */
export function drawPictogram(ctx: Ctx, world: World, zone: Zone, colours: Colours): void {
  const { x, y, width, depth } = areaOf(zone);
  const scale = (PICTOGRAM_PART * Math.min(width, depth)) / PICTOGRAM_SIZE;
  ctx.save();
  ctx.translate(x, y);
  ctx.scale(scale, -scale);
  ctx.translate(-PICTOGRAM_SIZE / 2, -PICTOGRAM_SIZE / 2);
  ctx.fillStyle = inkOn(world, zone) ?? colours.ink;
  ctx.fill(new Path2D(pictogramOf(zone.name) ?? ""), "evenodd");
  ctx.restore();
}

/** White does not stand out on yellow. */
const DARK = "#3c2f12";
const LOST = 1.7;

/** The colour of a pictogram on its field; null if the field is not painted. */
export function inkOn({ floor }: World, zone: Zone): string | null {
  const { x, y } = areaOf(zone);
  const below = floor?.findLast((paint) => contains(areaOf(paint), { x, y }));
  if (!below) return null;
  return contrast("#ffffff", paintOf(below.color)) < LOST ? DARK : "#ffffff";
}

/** Draws the names of pictured places on plates beside their fields, over all that stands there. */
export function drawPlates(ctx: Ctx, world: World, colours: Colours, pixel: number): void {
  const letters = lettersAt(pixel);
  ctx.save();
  ctx.font = `700 100px ${colours.font}`;
  const widthOf = (text: string) => (ctx.measureText(text).width / 100 + 0.9) * letters;
  for (const { text, plate } of platesOf(world, widthOf, 1.4 * letters)) {
    drawPlate(ctx, text, plate, letters, colours, pixel);
  }
  ctx.restore();
}

/** Height of the letters, in metres, where a pixel has `pixel` metres. */
const lettersAt = (pixel: number) => Math.max(NAME_M, READABLE_PX * pixel);

interface Plate {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly depth: number;
}

/** A name on its plate. */
interface NamedPlate {
  readonly zone: Zone;
  readonly text: string;
  readonly plate: Plate;
}

/**
 * The plates that fit: on a small floor a name goes without its translation; one that would lie on others wherever it
 * lies is left out. Its pictogram stays.
 */
export function platesOf(
  world: World,
  widthOf: (text: string) => number,
  depth: number,
): NamedPlate[] {
  const placed: NamedPlate[] = [];
  for (const zone of world.zones ?? []) {
    if (!isPictured(world, zone)) continue;
    const candidates = textsOf(zone).flatMap((text) =>
      platesFor(world, zone, widthOf(text), depth)
        .filter((plate, rank) => rank === 0 || isInside(world, plate))
        .map((plate) => ({ zone, text, plate })),
    );
    const found = candidates.find(
      ({ plate }) => !placed.some((other) => overlap(plate, other.plate)),
    );
    if (found) placed.push(found);
  }
  return placed;
}

/** The name with its translation, if it has one, then the name alone. */
function textsOf({ name }: Zone): string[] {
  const translation = translationOf(name);
  return translation ? [`${name} · ${translation}`, name] : [name];
}

function drawPlate(
  ctx: Ctx,
  text: string,
  plate: Plate,
  letters: number,
  colours: Colours,
  pixel: number,
): void {
  ctx.save();
  ctx.translate(plate.x, plate.y);
  ctx.beginPath();
  ctx.roundRect(-plate.width / 2, -plate.depth / 2, plate.width, plate.depth, plate.depth / 2);
  ctx.fillStyle = colours.tile;
  ctx.fill();
  ctx.strokeStyle = colours.line;
  ctx.lineWidth = pixel;
  ctx.stroke();
  ctx.scale(letters / 100, -letters / 100);
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  ctx.fillStyle = colours.ink;
  ctx.fillText(text, 0, 4);
  ctx.restore();
}

/** Whether the name of the place at a point of the world frame lies below its field. */
export function hasPlateBelow(world: World, point: XY, pixel = 0): boolean {
  const zone = (world.zones ?? []).find((one) => contains(areaOf(one), point));
  if (!zone || !isPictured(world, zone)) return false;
  const letters = lettersAt(pixel);
  return plateOf(world, zone, letters * 5, letters * 1.4).y < areaOf(zone).y;
}

/** The name of a place in the language of the page; null if it is the same word, or none is known. */
export function translationOf(name: string): string | null {
  const known = new Map<string, string>(Object.entries(texts.peek().places)).get(name) ?? name;
  return known === name ? null : known;
}

/** Where a plate lies: beside its field, where it covers least. */
export const plateOf = (...of: Parameters<typeof platesFor>): Plate => platesFor(...of)[0] as Plate;

/** The plates beside the field of a place, the one that covers least first. */
function platesFor(world: World, zone: Zone, width: number, depth: number): Plate[] {
  const field = areaOf(zone);
  const [down, across] = [(field.depth + depth) / 2 + GAP_M, (field.width + width) / 2 + GAP_M];
  const aside = Math.abs(field.width - width) / 2;
  const steps = [
    ...[0, aside, -aside].flatMap((x) => [[x, -down] as const, [x, down] as const]),
    [across, 0] as const,
    [-across, 0] as const,
  ];
  const plates = steps.map(([x, y]) => ({ x: field.x + x, y: field.y + y, width, depth }));
  const obstacles = obstaclesBeside(world, field);
  const streets = (world.prints ?? []).filter(({ kind }) => kind === "street").map(areaOf);
  const cost = (plate: Plate) =>
    (isInside(world, plate) ? 0 : 100) +
    10 * obstacles.filter((area) => isOn(plate, area)).length +
    streets.filter((area) => isOn(plate, area)).length;
  return plates
    .map((plate) => ({ plate, cost: cost(plate) }))
    .sort((one, other) => one.cost - other.cost)
    .map(({ plate }) => plate);
}

/** What a plate must not cover: other places and colours, things, walls. */
function obstaclesBeside(world: World, field: Area): Area[] {
  const areas = [...(world.zones ?? []), ...(world.floor ?? []), ...world.boxes].map(areaOf);
  const walls = world.walls.map(({ from: [x1, y1], to: [x2, y2] }) =>
    areaOf({
      center: [(x1 + x2) / 2, (y1 + y2) / 2],
      size: [Math.abs(x2 - x1) + WALL_M, Math.abs(y2 - y1) + WALL_M],
    }),
  );
  return [...areas.filter(({ x, y }) => x !== field.x || y !== field.y), ...walls];
}

function isInside(world: World, { x, y, width, depth }: Plate): boolean {
  const room = roomOf(world);
  return (
    x - width / 2 >= room.left &&
    x + width / 2 <= room.right &&
    y - depth / 2 >= room.bottom &&
    y + depth / 2 <= room.top
  );
}

function overlap(one: Plate, other: Plate): boolean {
  return (
    Math.abs(one.x - other.x) < (one.width + other.width) / 2 &&
    Math.abs(one.y - other.y) < (one.depth + other.depth) / 2
  );
}

/** Whether a plate overlaps the box around an area. */
function isOn(plate: Plate, area: Area): boolean {
  const turned = (area.heading * Math.PI) / 180;
  const [cos, sin] = [Math.abs(Math.cos(turned)), Math.abs(Math.sin(turned))];
  const width = area.width * cos + area.depth * sin;
  const depth = area.width * sin + area.depth * cos;
  return overlap(plate, { x: area.x, y: area.y, width, depth });
}
