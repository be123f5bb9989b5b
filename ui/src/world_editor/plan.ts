import type { World } from "../api/model";
import type { Area } from "../scene/areas";
import type { XY } from "../scene/frames";
import type { BoxKind } from "../scene/mat/boxes";
import type { Ground } from "../scene/mat/grounds";
import type { PrintKind } from "../scene/mat/prints";

/** An object on the floor. `id` is valid while the editor is open; a document identifies objects by index. */
export type WorldObject = Wall | Box | Zone | Paint | Print;
export type Kind = WorldObject["kind"];

interface ObjectBase<K extends string> {
  readonly id: string;
  readonly kind: K;
}

export interface Wall extends ObjectBase<"wall"> {
  readonly from: XY;
  readonly to: XY;
}

export interface Box extends ObjectBase<"box">, Area {
  readonly radius: null;
  readonly movable: boolean;
  readonly mass: number | null;
  readonly boxKind: BoxKind | null;
}

export interface Zone extends ObjectBase<"zone">, Area {
  readonly name: string;
}

export interface Paint extends ObjectBase<"paint">, Area {
  readonly color: string;
}

export interface Print extends ObjectBase<"print">, Area {
  readonly radius: null;
  readonly print: PrintKind;
  readonly color: string | null;
}

export type AreaObject = Box | Zone | Paint | Print;

export interface Start extends XY {
  readonly heading: number;
}

/** Immutable state of a world in the editor. */
export interface FloorPlan {
  readonly name: string;
  readonly title: World["title"];
  readonly width: number;
  readonly depth: number;
  readonly ground: Ground | null;
  readonly start: Start;
  readonly objects: readonly WorldObject[];
}

let counted = 0;
export const newId = () => `thing-${++counted}`;

/** The object with an id; null if there is none. */
export const objectOf = (plan: FloorPlan, id: string | null): WorldObject | null =>
  plan.objects.find((object) => object.id === id) ?? null;

export const isArea = (one: WorldObject): one is AreaObject => one.kind !== "wall";

export const ofKind = (plan: FloorPlan, kind: Kind): readonly WorldObject[] =>
  plan.objects.filter((object) => object.kind === kind);

export function replaceObject(plan: FloorPlan, changed: WorldObject): FloorPlan {
  const objects = plan.objects.map((object) => (object.id === changed.id ? changed : object));
  return { ...plan, objects };
}

export const addObject = (plan: FloorPlan, object: WorldObject): FloorPlan => ({
  ...plan,
  objects: [...plan.objects, object],
});

export const removeObject = (plan: FloorPlan, id: string): FloorPlan => ({
  ...plan,
  objects: plan.objects.filter((object) => object.id !== id),
});

const EDGE_M = 0.01;

/** Whether an object is an outer wall: it follows the floor's size and cannot be dragged. */
export function isOuter(plan: FloorPlan, object: WorldObject): boolean {
  if (object.kind !== "wall") return false;
  const { from, to } = object;
  const along = (a: number, b: number, reach: number) => Math.abs(Math.abs(a - b) - reach) < EDGE_M;
  const on = (a: number, b: number, edge: number) =>
    Math.abs(a - b) < EDGE_M && Math.abs(Math.abs(a) - edge / 2) < EDGE_M;
  return (
    (on(from.x, to.x, plan.width) && along(from.y, to.y, plan.depth)) ||
    (on(from.y, to.y, plan.depth) && along(from.x, to.x, plan.width))
  );
}

/** Resizes the floor and its outer walls. */
export function resized(plan: FloorPlan, width: number, depth: number): FloorPlan {
  const stretch = ({ x, y }: XY): XY => ({
    x: (Math.sign(x) * width) / 2,
    y: (Math.sign(y) * depth) / 2,
  });
  const objects = plan.objects.map((object) =>
    object.kind === "wall" && isOuter(plan, object)
      ? { ...object, from: stretch(object.from), to: stretch(object.to) }
      : object,
  );
  return { ...plan, width, depth, objects };
}
