import type { World } from "../api/model";
import type { Area } from "../scene/areas";
import type { XY } from "../scene/frames";

/** A thing on the floor. `id` is valid while the editor is open; a document identifies things by index. */
export type Thing = Wall | Box | Zone | Paint;
export type Kind = Thing["kind"];

interface One<K extends string> {
  readonly id: string;
  readonly kind: K;
}

export interface Wall extends One<"wall"> {
  readonly from: XY;
  readonly to: XY;
}

export interface Box extends One<"box">, Area {
  readonly radius: null;
  readonly movable: boolean;
  readonly mass: number | null;
}

export interface Zone extends One<"zone">, Area {
  readonly name: string;
}

export interface Paint extends One<"paint">, Area {
  readonly color: string;
}

export type AreaThing = Box | Zone | Paint;

export interface Start extends XY {
  readonly heading: number;
}

/** Immutable state of a world in the editor. */
export interface Plan {
  readonly name: string;
  readonly title: World["title"];
  readonly width: number;
  readonly depth: number;
  readonly start: Start;
  readonly things: readonly Thing[];
}

let counted = 0;
export const newId = () => `thing-${++counted}`;

/** The thing with an id; null where there is none. */
export const thingOf = (plan: Plan, id: string | null): Thing | null =>
  plan.things.find((thing) => thing.id === id) ?? null;

export const isArea = (thing: Thing): thing is AreaThing => thing.kind !== "wall";

export const ofKind = (plan: Plan, kind: Kind): readonly Thing[] =>
  plan.things.filter((thing) => thing.kind === kind);

export function withThing(plan: Plan, changed: Thing): Plan {
  const things = plan.things.map((thing) => (thing.id === changed.id ? changed : thing));
  return { ...plan, things };
}

export const plusThing = (plan: Plan, thing: Thing): Plan => ({
  ...plan,
  things: [...plan.things, thing],
});

export const withoutThing = (plan: Plan, id: string): Plan => ({
  ...plan,
  things: plan.things.filter((thing) => thing.id !== id),
});

const EDGE_M = 0.01;

/** Whether a thing is an outer wall: it follows the floor's size and cannot be dragged. */
export function isOuter(plan: Plan, thing: Thing): boolean {
  if (thing.kind !== "wall") return false;
  const { from, to } = thing;
  const along = (a: number, b: number, reach: number) => Math.abs(Math.abs(a - b) - reach) < EDGE_M;
  const on = (a: number, b: number, edge: number) =>
    Math.abs(a - b) < EDGE_M && Math.abs(Math.abs(a) - edge / 2) < EDGE_M;
  return (
    (on(from.x, to.x, plan.width) && along(from.y, to.y, plan.depth)) ||
    (on(from.y, to.y, plan.depth) && along(from.x, to.x, plan.width))
  );
}

/** Resizes the floor and its outer walls. */
export function resized(plan: Plan, width: number, depth: number): Plan {
  const stretch = ({ x, y }: XY): XY => ({
    x: (Math.sign(x) * width) / 2,
    y: (Math.sign(y) * depth) / 2,
  });
  const things = plan.things.map((thing) =>
    thing.kind === "wall" && isOuter(plan, thing)
      ? { ...thing, from: stretch(thing.from), to: stretch(thing.to) }
      : thing,
  );
  return { ...plan, width, depth, things };
}
