import type { World } from "../../api/model";
import type { RunView } from "../../run/reducer";
import type { Point, Trail } from "../../run/trail";
import { type Box, include, roomOf, type StartPose, startOf, toWorld } from "../frames";

/** Margins around the start and around the path, and the walls' thickness, in metres. */
const AROUND_START = 2.1;
const AROUND_PATH = 0.6;
const WALL = 0.12;

/** Paths of many robots, world frame, metres. */
export interface Paths {
  readonly paths: readonly { readonly path: readonly (readonly [x: number, y: number])[] }[];
}

/**
 * Bounding box of the start, the path so far, the paths of a bundle and all objects in the room. The viewport shows this
 * box and not the whole room: in a large empty room the robot would be too small. While the program
 * waits for a sign, which often names a place, the box holds the places only.
 */
export function contentBounds(
  world: World | null,
  view: RunView,
  companion: { readonly world: World | null; readonly view: RunView } | null = null,
  bundle: Paths | null = null,
): Box {
  const room = roomOf(world);
  const start = startOf(world);
  const choice = view.capture && placesOf(world);
  if (choice) return inside(choice, room);
  const box: Box = { left: start.x, right: start.x, bottom: start.y, top: start.y };
  include(box, start.x, start.y, AROUND_START);
  if (world) includeObjects(box, world);
  includePath(box, start, view.path);
  if (companion) includePath(box, startOf(companion.world), companion.view.path);
  for (const { path } of bundle?.paths ?? [])
    for (const [x, y] of path) include(box, x, y, AROUND_PATH);
  return inside(box, room);
}

/** Extends `box` by all objects of a world and all areas on its floor. */
export function includeObjects(box: Box, world: World): void {
  for (const worldBox of world.boxes) {
    const [x, y] = worldBox.center;
    include(box, x ?? 0, y ?? 0, Math.hypot(...worldBox.size) / 2);
  }
  // a world of the world editor omits empty lists
  for (const area of [...(world.zones ?? []), ...(world.floor ?? [])]) includeArea(box, area);
  for (const wall of world.walls) {
    if (isOuter(wall, roomOf(world))) continue;
    for (const [x, y] of [wall.from, wall.to]) include(box, x ?? 0, y ?? 0);
  }
}

type Area = Pick<World["zones"][number], "center" | "radius" | "size">;

function includeArea(box: Box, { center, radius, size }: Area): void {
  const [x = 0, y = 0] = center;
  include(box, x, y, radius ?? Math.hypot(...(size ?? [])) / 2);
}

/** The box of a world's places; null without any. */
function placesOf(world: World | null): Box | null {
  const [first, ...others] = world?.zones ?? [];
  if (!first) return null;
  const [x = 0, y = 0] = first.center;
  const box: Box = { left: x, right: x, bottom: y, top: y };
  for (const zone of [first, ...others]) includeArea(box, zone);
  return box;
}

function includePath(box: Box, start: StartPose, path: Trail): void {
  for (const [x, y] of corners(path)) {
    const place = toWorld(start, x, y);
    include(box, place.x, place.y, AROUND_PATH);
  }
}

/** Cache of the corners of full chunks, which no longer change. */
const known = new WeakMap<readonly Point[], readonly Point[]>();

/**
 * Corners of the full chunks' bounding boxes, and the newest points. With a rotated start frame
 * the boxes are larger than the path.
 */
function* corners({ chunks, tail }: Trail): Generator<Point> {
  for (const chunk of chunks) {
    let found = known.get(chunk);
    if (!found) {
      const [xs, ys] = [chunk.map(([x]) => x), chunk.map(([, y]) => y)];
      const [left, right] = [Math.min(...xs), Math.max(...xs)];
      const [bottom, top] = [Math.min(...ys), Math.max(...ys)];
      found = [
        [left, bottom],
        [right, bottom],
        [left, top],
        [right, top],
      ];
      known.set(chunk, found);
    }
    yield* found;
  }
  yield* tail;
}

/** Box of the whole room with its walls. */
export function wholeRoom(world: World | null): Box {
  const room = roomOf(world);
  return {
    left: room.left - WALL,
    right: room.right + WALL,
    bottom: room.bottom - WALL,
    top: room.top + WALL,
  };
}

function isOuter(wall: World["walls"][number], room: Box): boolean {
  const at = (a: number | undefined, b: number | undefined, edge: number) =>
    Math.abs((a ?? 0) - edge) < 0.01 && Math.abs((b ?? 0) - edge) < 0.01;
  const [fromX, fromY] = wall.from;
  const [toX, toY] = wall.to;
  return (
    at(fromX, toX, room.left) ||
    at(fromX, toX, room.right) ||
    at(fromY, toY, room.bottom) ||
    at(fromY, toY, room.top)
  );
}

/** Shifts the box into the room if it exceeds the room, then clips the rest. */
function inside(box: Box, room: Box): Box {
  const outer = {
    left: room.left - WALL,
    right: room.right + WALL,
    bottom: room.bottom - WALL,
    top: room.top + WALL,
  };
  const dx = Math.max(0, outer.left - box.left) - Math.max(0, box.right - outer.right);
  const dy = Math.max(0, outer.bottom - box.bottom) - Math.max(0, box.top - outer.top);
  return {
    left: Math.max(outer.left, box.left + dx),
    right: Math.min(outer.right, box.right + dx),
    bottom: Math.max(outer.bottom, box.bottom + dy),
    top: Math.min(outer.top, box.top + dy),
  };
}
