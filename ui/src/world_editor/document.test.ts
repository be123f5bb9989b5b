import { describe, expect, test } from "vitest";
import type { World } from "../api/model";
import { aboutOf, documentOf, planOf } from "./document";
import { ofKind } from "./plan";

const SHIPPED = import.meta.glob<World>("../../../sim/worlds/*.json", {
  eager: true,
  import: "default",
});

describe.each(Object.entries(SHIPPED))("the world %s", (_, world) => {
  test("is the same after it has been on the editor's table", () => {
    expect(documentOf(planOf(world))).toEqual(world);
  });
});

const EVERYTHING = {
  pinel_world: 1,
  name: "own",
  title: "Nosso mundo",
  size_m: [6, 4],
  start: { x_m: -1, y_m: 0.5, heading_deg: 90 },
  walls: [{ from: [0, 0], to: [1, 1] }],
  boxes: [
    { center: [1, 1], size: [0.5, 0.4], heading_deg: 30, movable: true, mass_kg: 3, kind: "chair" },
    { center: [2, 1], size: [0.5, 0.4], heading_deg: 0 },
  ],
  zones: [
    { name: "A", center: [0, 0], size: [1, 2], heading_deg: 45 },
    { name: "B", center: [1, 0], radius: 0.5 },
  ],
  floor: [{ color: "red", center: [0, 0], radius: 0.3 }],
  ground: "town",
  prints: [
    { kind: "street", center: [0, 1], size: [4, 0.7], heading_deg: 0 },
    { kind: "roof", center: [0, -1], size: [1, 0.7], heading_deg: 10, color: "blue" },
  ],
};

test("a world with one of everything is the same too", () => {
  expect(documentOf(planOf(EVERYTHING as unknown as World))).toEqual(EVERYTHING);
});

test("what the server fills in is left out again", () => {
  const filled = {
    ...EVERYTHING,
    boxes: EVERYTHING.boxes.map((box) => ({ movable: false, mass_kg: 2, ...box })),
    zones: EVERYTHING.zones.map((zone) => ({ radius: null, size: null, heading_deg: 0, ...zone })),
  };
  expect(documentOf(planOf(filled as unknown as World))).toEqual(EVERYTHING);
});

test("a fault is laid at the thing that it speaks of", () => {
  const plan = planOf(EVERYTHING as unknown as World);
  expect(aboutOf(plan, "/boxes/1/size/0")).toBe(ofKind(plan, "box")[1]?.id);
  expect(aboutOf(plan, "/zones/0/name")).toBe(ofKind(plan, "zone")[0]?.id);
  expect(aboutOf(plan, "/start")).toBe("start");
  expect(aboutOf(plan, "/title")).toBeNull();
  expect(aboutOf(plan, "/walls/7")).toBeNull();
});
