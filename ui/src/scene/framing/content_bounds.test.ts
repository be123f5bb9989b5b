import { describe, expect, test } from "vitest";
import type { World } from "../../api/model";
import { IDLE, type RunView } from "../../run/reducer";
import { EMPTY_TRAIL, extend } from "../../run/trail";
import { startOf, toStart, toWorld } from "../frames";
import { contentBounds } from "./content_bounds";
import {
  EDGE,
  EDGE_WITH_CONTROLS,
  EDGE_WITH_TOOLS,
  marginsOf,
  toScreen,
  viewportFor,
} from "./viewport";

const world = (over: Partial<World> = {}): World => ({
  pinel_world: 1,
  name: "room",
  title: { "pt-BR": "Sala", en: "Room", es: "Sala" },
  size_m: [8, 8],
  start: { x_m: 0, y_m: 0, heading_deg: 0 },
  walls: [{ from: [-4, -4], to: [4, -4] }],
  ground: null,
  prints: [],
  boxes: [],
  zones: [],
  floor: [],
  ...over,
});

describe("what is shown of a room", () => {
  test("an empty one is shown around the start, not whole", () => {
    const box = contentBounds(world(), IDLE);
    expect(box.right - box.left).toBeLessThan(5);
  });

  test("holds what is painted on the floor, and named places", () => {
    const place = { center: [3, 0] as [number, number], heading_deg: 0 };
    const zone = { ...place, name: "A", size: [1, 1] as [number, number], radius: null };
    const paint = { ...place, color: "red", radius: 0.4, size: null };
    expect(contentBounds(world({ zones: [zone] }), IDLE).right).toBeGreaterThan(3.4);
    expect(contentBounds(world({ floor: [paint] }), IDLE).right).toBeGreaterThan(3.3);
  });

  test("is the places while a sign is asked, large enough to choose one of them", () => {
    const asked = { ...IDLE, capture: {} } as RunView;
    const zone = (x: number) => ({
      center: [x, 1] as [number, number],
      heading_deg: 0,
      name: "A",
      size: [1, 1] as [number, number],
      radius: null,
    });
    const box = contentBounds(world({ zones: [zone(1), zone(3)] }), asked);
    expect(box.left).toBeGreaterThan(0);
    expect(box.right - box.left).toBeLessThan(3.5);
    expect(contentBounds(world(), asked)).toEqual(contentBounds(world(), IDLE));
  });

  test("is that of a world of the editor, too, which leaves empty lists out", () => {
    const { zones, floor, ...rest } = world();
    expect(contentBounds(rest as World, IDLE)).toEqual(contentBounds(world(), IDLE));
  });

  test("holds the paths of many robots", () => {
    const paths = [{ id: 1, well: true, path: [[0, 0] as const, [3, 0] as const] }];
    const bundle = { paths, isFaint: false };
    expect(contentBounds(world(), IDLE, null, bundle).right).toBeGreaterThan(3.2);
  });

  test("grows with the path", () => {
    const path = extend(extend(EMPTY_TRAIL, [0, 0]), [3, 0]);
    expect(contentBounds(world(), { ...IDLE, path }).right).toBeGreaterThan(3.2);
  });

  test("holds what stands in it", () => {
    const boxes = [
      {
        center: [-3, 3] as [number, number],
        size: [1, 1] as [number, number],
        heading_deg: 0,
        movable: false,
        mass_kg: 2,
        kind: null,
      },
    ];
    const box = contentBounds(world({ boxes }), IDLE);
    expect(box.left).toBeLessThan(-3.5);
    expect(box.top).toBeGreaterThan(3.5);
  });

  test("never leaves the room", () => {
    const box = contentBounds(world({ start: { x_m: -3.8, y_m: 0, heading_deg: 0 } }), IDLE);
    expect(box.left).toBeCloseTo(-4.12);
    expect(box.right - box.left).toBeCloseTo(4.2);
  });
});

describe("frames", () => {
  test("the start frame turns with the start's heading", () => {
    const start = startOf(world({ start: { x_m: 1, y_m: 2, heading_deg: 90 } }));
    const ahead = toWorld(start, 1, 0);
    expect(ahead.x).toBeCloseTo(1);
    expect(ahead.y).toBeCloseTo(3);
    const back = toStart(start, ahead.x, ahead.y);
    expect(back.x).toBeCloseTo(1);
    expect(back.y).toBeCloseTo(0);
  });

  test("a camera shows all of what it is for, clear of the rulers", () => {
    const size = { width: 550, height: 480 };
    const viewport = viewportFor({ left: -2, right: 2, bottom: -3, top: 1 }, size);
    const corner = toScreen(viewport, size, { x: -2, y: -3 });
    expect(corner.x).toBeGreaterThanOrEqual(EDGE.left - 0.01);
    expect(corner.y).toBeLessThanOrEqual(size.height - EDGE.bottom + 0.01);
  });
});

test("a room that fills the floor's width ends beside the tools", () => {
  const size = { width: 550, height: 426 };
  const room = { left: -4, right: 4, bottom: -2.5, top: 2.5 };
  const { x, y } = toScreen(viewportFor(room, size, EDGE_WITH_TOOLS), size, { x: 4, y: -2.5 });
  expect(x).toBeLessThanOrEqual(size.width - EDGE_WITH_TOOLS.right + 0.01);
  expect(y).toBeLessThanOrEqual(size.height - EDGE.bottom + 0.01);
});

test("a floor that is taller than its content shows it in the middle, below the controls", () => {
  const size = { width: 340, height: 940 };
  const room = { left: -4, right: 4, bottom: -2.5, top: 2.5 };
  const viewport = viewportFor(room, size, EDGE_WITH_CONTROLS);
  const above = toScreen(viewport, size, { x: 0, y: 2.5 }).y - EDGE_WITH_CONTROLS.top;
  const below =
    size.height - EDGE_WITH_CONTROLS.bottom - toScreen(viewport, size, { x: 0, y: -2.5 }).y;
  expect(above).toBeCloseTo(below);
});

test("a room as high as the floor ends below the controls, which must not cover a robot at its wall", () => {
  const size = { width: 900, height: 367 };
  const room = { left: -4, right: 4, bottom: -4, top: 4 };
  const viewport = viewportFor(room, size, EDGE_WITH_CONTROLS);
  expect(toScreen(viewport, size, { x: 0, y: 4 }).y).toBeGreaterThanOrEqual(66);
});

test("on a low floor, where the tools are side by side, a path ends beside both", () => {
  const right = (height: number) => marginsOf({ width: 313, height }, 1, true).right;
  expect(right(345)).toBe(EDGE_WITH_TOOLS.right);
  expect(right(344)).toBe(EDGE_WITH_TOOLS.right + 44);
});
