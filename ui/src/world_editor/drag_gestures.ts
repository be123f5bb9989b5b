import type { XY } from "../scene/frames";
import type { BoxKind } from "../scene/mat/boxes";
import type { PrintKind } from "../scene/mat/prints";
import {
  between,
  clean,
  corneredTo,
  FINE,
  GRID,
  headingTo,
  insideRoom,
  lengthOf,
  MIN_SIZE_M,
  placed,
  reachingTo,
  shifted,
  snap,
  snapEnd,
} from "./geometry";
import {
  addObject,
  type FloorPlan,
  isArea,
  newId,
  objectOf,
  replaceObject,
  type WorldObject,
} from "./plan";

/** Drawing tools. */
export type Tool = "select" | "wall" | "box" | "zone" | "paint" | "print" | "start";
export const TOOLS: readonly Tool[] = ["select", "wall", "box", "zone", "paint", "print", "start"];

/** Properties of the next object to draw. */
export interface NextObjectOptions {
  readonly color: string;
  readonly movable: boolean;
  readonly boxKind: BoxKind | null;
  readonly print: PrintKind;
  /** Name of the next zone. */
  readonly name: string;
}

/** Returns the plan for the pointer at a point. `free`: rounds to centimetres, without grid and snapping. */
export type DragGesture = (point: XY, free: boolean) => FloorPlan;

/** Drags an object, or the start, by the point at which it was pressed. */
export function moving(plan: FloorPlan, id: string, grip: XY): DragGesture {
  const object = objectOf(plan, id);
  const anchor = object ? anchorOf(object) : plan.start;
  return (point, free) => {
    const step = free ? FINE : GRID;
    const goal = {
      x: snap(anchor.x + point.x - grip.x, step),
      y: snap(anchor.y + point.y - grip.y, step),
    };
    if (!object) return { ...plan, start: placed(plan, plan.start, goal, true) };
    return replaceObject(plan, shifted(plan, object, goal.x - anchor.x, goal.y - anchor.y));
  };
}

/** The point that snaps to the grid: a corner if the edges follow the grid, else the centre. */
function anchorOf(object: WorldObject): XY {
  if (!isArea(object)) return object.from;
  if (object.radius !== null || object.heading % 90 !== 0) return object;
  const sideways = object.heading % 180 !== 0;
  const [width, depth] = sideways ? [object.depth, object.width] : [object.width, object.depth];
  return { x: object.x - width / 2, y: object.y - depth / 2 };
}

/** Drags a handle: "from" and "to" of a wall, "0" to "3" for a rectangle's corners, "radius", "turn". */
export function pulling(plan: FloorPlan, id: string, handle: string): DragGesture {
  const object = objectOf(plan, id);
  return (point, free) => {
    if (!object) return turned(plan, point, free);
    return replaceObject(plan, pulled(plan, object, handle, point, free));
  };
}

function turned(plan: FloorPlan, point: XY, free: boolean): FloorPlan {
  return { ...plan, start: { ...plan.start, heading: headingTo(plan.start, point, free) } };
}

function pulled(
  plan: FloorPlan,
  object: WorldObject,
  handle: string,
  point: XY,
  free: boolean,
): WorldObject {
  if (!isArea(object)) {
    const other = handle === "from" ? object.to : object.from;
    const wall = { ...object, [handle]: snapEnd(plan, point, object.id, other, free) };
    return lengthOf(wall) < MIN_SIZE_M ? object : wall;
  }
  if (handle === "turn") return { ...object, heading: headingTo(object, point, free) };
  if (handle === "radius") return reachingTo(object, point, free);
  return corneredTo(object, Number(handle), insideRoom(plan, point), free);
}

/** Draws an object of the tool from the point at which the pointer was pressed. */
export function drawing(
  plan: FloorPlan,
  tool: Tool,
  from: XY,
  options: NextObjectOptions,
): DragGesture {
  const id = newId();
  if (tool === "start") return starting(plan, from);
  if (tool === "wall") return walling(plan, id, from);
  return (point, free) => {
    const rectangle = between(insideRoom(plan, from), insideRoom(plan, point), free);
    if (rectangle.width < MIN_SIZE_M || rectangle.depth < MIN_SIZE_M) return plan;
    return addObject(plan, made(tool, id, rectangle, options));
  };
}

/** Sets the start to the pressed point, facing the pointer. */
function starting(plan: FloorPlan, from: XY): DragGesture {
  return (point, free) => {
    const start = placed(plan, plan.start, from, free);
    const away = Math.hypot(point.x - from.x, point.y - from.y);
    return away < AIM_M ? { ...plan, start } : turned({ ...plan, start }, point, free);
  };
}

const AIM_M = 0.3;

function walling(plan: FloorPlan, id: string, from: XY): DragGesture {
  return (point, free) => {
    const start = snapEnd(plan, from, id, null, free);
    const wall = {
      id,
      kind: "wall" as const,
      from: start,
      to: snapEnd(plan, point, id, start, free),
    };
    return lengthOf(wall) < MIN_SIZE_M ? plan : addObject(plan, wall);
  };
}

type Rectangle = ReturnType<typeof between>;

function made(
  tool: Tool,
  id: string,
  rectangle: Rectangle,
  { color, movable, boxKind, print, name }: NextObjectOptions,
): WorldObject {
  const area = { ...rectangle, heading: 0, radius: null };
  if (tool === "box") return { id, kind: "box", ...area, movable, mass: null, boxKind };
  if (tool === "zone") return { id, kind: "zone", ...area, name };
  if (tool === "print") return { id, kind: "print", ...area, print, color: null };
  return { id, kind: "paint", ...area, color };
}

/** Width and depth of an object placed by a tap, metres. */
const TAPPED = { box: 0.6, zone: 1, paint: 1, print: 1 } as const;

/** Places an object at a point, for a tap or a key. */
export function tapped(plan: FloorPlan, tool: Tool, at: XY, options: NextObjectOptions): FloorPlan {
  if (tool === "select") return plan;
  if (tool === "start") return { ...plan, start: placed(plan, plan.start, at, false) };
  if (tool === "wall") {
    const { x, y } = insideRoom(plan, at);
    const [from, to] = [
      { x: x - 0.5, y },
      { x: x + 0.5, y },
    ];
    return drawing(plan, tool, from, options)(to, false);
  }
  const half = TAPPED[tool] / 2;
  const from = { x: at.x - half, y: at.y - half };
  return drawing(plan, tool, from, options)({ x: at.x + half, y: at.y + half }, false);
}

/** Adds a copy beside an object. */
export function doubled(plan: FloorPlan, object: WorldObject): [FloorPlan, string] {
  const id = newId();
  const copy = shifted(plan, { ...object, id }, 2 * GRID, -2 * GRID);
  return [addObject(plan, copy), id];
}

/** The first letter, else number, that no zone has as its name. */
export function freeName(plan: FloorPlan): string {
  const usedNames = new Set(
    plan.objects.map((object) => (object.kind === "zone" ? object.name : "")),
  );
  const letters = [..."ABCDEFGHIJKLMNOPQRSTUVWXYZ"];
  const letter = letters.find((one) => !usedNames.has(one));
  if (letter) return letter;
  let number = 1;
  while (usedNames.has(`${number}`)) number++;
  return `${number}`;
}

/** Moves an object, or the start, by metres. */
export function nudged(plan: FloorPlan, id: string, dx: number, dy: number): FloorPlan {
  const object = objectOf(plan, id);
  if (object) return replaceObject(plan, shifted(plan, object, dx, dy));
  const { start } = plan;
  const goal = { x: clean(start.x + dx), y: clean(start.y + dy) };
  return { ...plan, start: placed(plan, start, goal, true) };
}
