import type { World } from "../api/model";
import { type Area, areaOf } from "../scene/areas";
import { type FloorPlan, type Kind, newId, ofKind, type WorldObject } from "./plan";

/** Lists of the document and the kind of object in each, in drawing order. */
export const LISTS = {
  walls: "wall",
  boxes: "box",
  zones: "zone",
  floor: "paint",
  prints: "print",
} as const;

type Point = [number, number];
type Shape = { center: Point; size?: Point; heading_deg?: number; radius?: number };

/** Converts a document that the server sent or validated to a plan. */
export function planOf(world: World): FloorPlan {
  const { start } = world;
  return {
    name: world.name,
    title: world.title,
    width: world.size_m[0],
    depth: world.size_m[1],
    ground: world.ground ?? null,
    start: { x: start.x_m, y: start.y_m, heading: start.heading_deg },
    objects: [
      ...world.walls.map((wall) => ({
        id: newId(),
        kind: "wall" as const,
        from: xy(wall.from),
        to: xy(wall.to),
      })),
      ...(world.boxes ?? []).map(boxOf),
      ...(world.zones ?? []).map((zone) => ({
        id: newId(),
        kind: "zone" as const,
        ...areaOf(zone),
        name: zone.name,
      })),
      ...(world.floor ?? []).map((paint) => ({
        id: newId(),
        kind: "paint" as const,
        ...areaOf(paint),
        color: paint.color,
      })),
      ...(world.prints ?? []).map((print) => ({
        id: newId(),
        kind: "print" as const,
        ...areaOf(print),
        radius: null,
        print: print.kind,
        color: print.color ?? null,
      })),
    ],
  };
}

function boxOf(box: World["boxes"][number]): WorldObject {
  return {
    id: newId(),
    kind: "box",
    ...areaOf(box),
    radius: null,
    movable: box.movable ?? false,
    mass: box.movable ? (box.mass_kg ?? null) : null,
    boxKind: box.kind ?? null,
  };
}

const xy = ([x, y]: readonly number[]) => ({ x: x ?? 0, y: y ?? 0 });

/** The document of a plan, without empty optional lists. */
export function documentOf(plan: FloorPlan): World {
  const { start } = plan;
  const zones = ofKind(plan, "zone").map(entryOf);
  const floor = ofKind(plan, "paint").map(entryOf);
  const prints = ofKind(plan, "print").map(entryOf);
  const document = {
    pinel_world: 1,
    name: plan.name,
    title: plan.title,
    size_m: [plan.width, plan.depth],
    start: { x_m: start.x, y_m: start.y, heading_deg: start.heading },
    walls: ofKind(plan, "wall").map(entryOf),
    boxes: ofKind(plan, "box").map(entryOf),
    ...(zones.length > 0 && { zones }),
    ...(floor.length > 0 && { floor }),
    ...(plan.ground && { ground: plan.ground }),
    ...(prints.length > 0 && { prints }),
  };
  // default values are omitted, as in the shipped worlds
  return document as unknown as World;
}

function entryOf(item: WorldObject): object {
  switch (item.kind) {
    case "wall":
      return { from: [item.from.x, item.from.y], to: [item.to.x, item.to.y] };
    case "box":
      return {
        ...shapeOf(item),
        ...(item.movable && { movable: true }),
        ...(item.mass !== null && { mass_kg: item.mass }),
        ...(item.boxKind && { kind: item.boxKind }),
      };
    case "zone":
      return { name: item.name, ...shapeOf(item) };
    case "paint":
      return { color: item.color, ...shapeOf(item) };
    case "print":
      return {
        kind: item.print,
        ...shapeOf(item),
        ...(item.color && { color: item.color }),
      };
  }
}

function shapeOf(area: Area): Shape {
  const center: Point = [area.x, area.y];
  if (area.radius !== null) return { center, radius: area.radius };
  return { center, size: [area.width, area.depth], heading_deg: area.heading };
}

/** The subject of a fault: an object's id, "start", or null for the world itself. */
export function aboutOf(plan: FloorPlan, pointer: string): string | null {
  const [, list = "", index = ""] = pointer.split("/");
  if (list === "start") return "start";
  const kind: Kind | undefined = LISTS[list as keyof typeof LISTS];
  return (kind && ofKind(plan, kind)[Number(index)]?.id) ?? null;
}
