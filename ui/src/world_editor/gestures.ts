import type { XY } from "../scene/frames";
import {
  between,
  clean,
  corneredTo,
  FINE,
  GRID,
  headingTo,
  insideRoom,
  LEAST_M,
  lengthOf,
  placed,
  reachingTo,
  shifted,
  snap,
  snapEnd,
} from "./geometry";
import { isArea, newId, type Plan, plusThing, type Thing, thingOf, withThing } from "./plan";

/** Drawing tools. */
export type Tool = "select" | "wall" | "box" | "zone" | "paint" | "start";
export const TOOLS: readonly Tool[] = ["select", "wall", "box", "zone", "paint", "start"];

/** Properties of the next thing to be drawn. */
export interface Wishes {
  readonly color: string;
  readonly movable: boolean;
  /** Name of the next zone. */
  readonly name: string;
}

/** The plan with the pointer at a point. `free`: rounds to centimetres, without the grid and without snapping. */
export type Gesture = (point: XY, free: boolean) => Plan;

/** Drags a thing, or the start, by the point where it was pressed. */
export function moving(plan: Plan, id: string, grip: XY): Gesture {
  const thing = thingOf(plan, id);
  const anchor = thing ? anchorOf(thing) : plan.start;
  return (point, free) => {
    const step = free ? FINE : GRID;
    const goal = {
      x: snap(anchor.x + point.x - grip.x, step),
      y: snap(anchor.y + point.y - grip.y, step),
    };
    if (!thing) return { ...plan, start: placed(plan, plan.start, goal, true) };
    return withThing(plan, shifted(plan, thing, goal.x - anchor.x, goal.y - anchor.y));
  };
}

/** The point that snaps to the grid: a corner if the edges follow the grid, else the centre. */
function anchorOf(thing: Thing): XY {
  if (!isArea(thing)) return thing.from;
  if (thing.radius !== null || thing.heading % 90 !== 0) return thing;
  const sideways = thing.heading % 180 !== 0;
  const [width, depth] = sideways ? [thing.depth, thing.width] : [thing.width, thing.depth];
  return { x: thing.x - width / 2, y: thing.y - depth / 2 };
}

/** Drags a handle: "from" and "to" of a wall, "0" to "3" for a rectangle's corners, "radius", "turn". */
export function pulling(plan: Plan, id: string, handle: string): Gesture {
  const thing = thingOf(plan, id);
  return (point, free) => {
    if (!thing) return turned(plan, point, free);
    return withThing(plan, pulled(plan, thing, handle, point, free));
  };
}

function turned(plan: Plan, point: XY, free: boolean): Plan {
  return { ...plan, start: { ...plan.start, heading: headingTo(plan.start, point, free) } };
}

function pulled(plan: Plan, thing: Thing, handle: string, point: XY, free: boolean): Thing {
  if (!isArea(thing)) {
    const other = handle === "from" ? thing.to : thing.from;
    const wall = { ...thing, [handle]: snapEnd(plan, point, thing.id, other, free) };
    return lengthOf(wall) < LEAST_M ? thing : wall;
  }
  if (handle === "turn") return { ...thing, heading: headingTo(thing, point, free) };
  if (handle === "radius") return reachingTo(thing, point, free);
  return corneredTo(thing, Number(handle), insideRoom(plan, point), free);
}

/** Draws a thing of the tool from the point where the pointer was pressed. */
export function drawing(plan: Plan, tool: Tool, from: XY, wishes: Wishes): Gesture {
  const id = newId();
  if (tool === "start") return starting(plan, from);
  if (tool === "wall") return walling(plan, id, from);
  return (point, free) => {
    const room = between(insideRoom(plan, from), insideRoom(plan, point), free);
    if (room.width < LEAST_M || room.depth < LEAST_M) return plan;
    return plusThing(plan, made(tool, id, room, wishes));
  };
}

/** Sets the start to the pressed point, facing the pointer. */
function starting(plan: Plan, from: XY): Gesture {
  return (point, free) => {
    const start = placed(plan, plan.start, from, free);
    const away = Math.hypot(point.x - from.x, point.y - from.y);
    return away < AIM_M ? { ...plan, start } : turned({ ...plan, start }, point, free);
  };
}

const AIM_M = 0.3;

function walling(plan: Plan, id: string, from: XY): Gesture {
  return (point, free) => {
    const start = snapEnd(plan, from, id, null, free);
    const wall = {
      id,
      kind: "wall" as const,
      from: start,
      to: snapEnd(plan, point, id, start, free),
    };
    return lengthOf(wall) < LEAST_M ? plan : plusThing(plan, wall);
  };
}

type Room = ReturnType<typeof between>;

function made(tool: Tool, id: string, room: Room, { color, movable, name }: Wishes): Thing {
  const area = { ...room, heading: 0, radius: null };
  if (tool === "box") return { id, kind: "box", ...area, movable, mass: null };
  if (tool === "zone") return { id, kind: "zone", ...area, name };
  return { id, kind: "paint", ...area, color };
}

/** Width and depth of a thing placed by a tap, in metres. */
const TAPPED = { box: 0.6, zone: 1, paint: 1 } as const;

/** Places a thing at a point by a tap or a key. */
export function tapped(plan: Plan, tool: Tool, at: XY, wishes: Wishes): Plan {
  if (tool === "select") return plan;
  if (tool === "start") return { ...plan, start: placed(plan, plan.start, at, false) };
  if (tool === "wall") {
    const { x, y } = insideRoom(plan, at);
    const [from, to] = [
      { x: x - 0.5, y },
      { x: x + 0.5, y },
    ];
    return drawing(plan, tool, from, wishes)(to, false);
  }
  const half = TAPPED[tool] / 2;
  const from = { x: at.x - half, y: at.y - half };
  return drawing(plan, tool, from, wishes)({ x: at.x + half, y: at.y + half }, false);
}

/** Duplicates a thing beside itself. */
export function doubled(plan: Plan, thing: Thing): [Plan, string] {
  const id = newId();
  const copy = shifted(plan, { ...thing, id }, 2 * GRID, -2 * GRID);
  return [plusThing(plan, copy), id];
}

/** The first letter, or number, that no zone has as its name. */
export function freeName(plan: Plan): string {
  const taken = new Set(plan.things.map((thing) => (thing.kind === "zone" ? thing.name : "")));
  const letters = [..."ABCDEFGHIJKLMNOPQRSTUVWXYZ"];
  const letter = letters.find((one) => !taken.has(one));
  if (letter) return letter;
  let number = 1;
  while (taken.has(`${number}`)) number++;
  return `${number}`;
}

/** Moves the selected thing, or the start, by metres. */
export function nudged(plan: Plan, id: string, dx: number, dy: number): Plan {
  const thing = thingOf(plan, id);
  if (thing) return withThing(plan, shifted(plan, thing, dx, dy));
  const { start } = plan;
  const goal = { x: clean(start.x + dx), y: clean(start.y + dy) };
  return { ...plan, start: placed(plan, start, goal, true) };
}
