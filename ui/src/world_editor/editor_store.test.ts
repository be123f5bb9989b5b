import { beforeEach, describe, expect, test } from "vitest";
import emptyRoom from "../../../sim/worlds/empty_room.json";
import obstacles from "../../../sim/worlds/obstacles.json";
import type { World } from "../api/model";
import { EditorStore } from "./editor_store";

const EMPTY = emptyRoom as unknown as World;

let saved: World[];
let store: EditorStore;

beforeEach(() => {
  saved = [];
  store = new EditorStore(EMPTY, (world) => saved.push(world));
});

function drag(from: [number, number], to: [number, number], target = {}, free = false): void {
  const [a, b] = [from, to].map(([x, y]) => ({ x, y }));
  if (!a || !b) return;
  store.grip(target, a);
  store.drag({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 }, free);
  store.drag(b, free);
  store.endDrag(b, true);
}

function tap(x: number, y: number, id?: string): void {
  store.grip(id ? { id } : {}, { x, y });
  store.endDrag({ x, y }, false);
}

const drawn = () => store.document.value;
const handle = (name: string) => ({ handle: name });

describe("a hand", () => {
  test("draws a wall from end to end, kept once", () => {
    store.choose("wall");
    drag([1.02, -0.98], [1.03, 1.01]);
    expect(drawn().walls.at(-1)).toEqual({ from: [1, -1], to: [1, 1] });
    expect(saved).toHaveLength(1);
    expect(saved[0]).toBe(drawn());
  });

  test("that trembles draws no wall", () => {
    store.choose("wall");
    drag([1, 1], [1.02, 1]);
    tap(2, 2);
    expect(saved).toEqual([]);
  });

  test("draws boxes and places from corner to corner", () => {
    store.choose("box");
    store.movable.value = true;
    drag([1, 1], [2, 1.5]);
    store.choose("zone");
    drag([-1, -1], [-2, -2]);
    expect(drawn().boxes).toEqual([
      { center: [1.5, 1.25], size: [1, 0.5], heading_deg: 0, movable: true },
    ]);
    expect(drawn().zones).toEqual([
      { name: "A", center: [-1.5, -1.5], size: [1, 1], heading_deg: 0 },
    ]);
  });

  test("gives each place a name of its own", () => {
    store.choose("zone");
    for (const x of [-2, 0, 2]) tap(x, 0);
    expect(drawn().zones.map(({ name }) => name)).toEqual(["A", "B", "C"]);
  });

  test("puts the robot down, and turns it where it goes", () => {
    store.choose("start");
    drag([1.01, 1.02], [1, 3]);
    expect(drawn().start).toEqual({ x_m: 1, y_m: 1, heading_deg: 90 });
    tap(-2, -9);
    expect(drawn().start).toEqual({ x_m: -2, y_m: -3.7, heading_deg: 90 });
  });

  test("takes hold of what is drawn, moves, turns and stretches it", () => {
    store.choose("box");
    drag([0, 0], [1, 1]);
    const id = store.selected.value ?? "";
    store.choose("select");
    drag([0.5, 0.5], [1.52, 0.49], { id });
    expect(drawn().boxes[0]?.center).toEqual([1.5, 0.5]);
    drag([2.5, 0.5], [1.5, 3], handle("turn"));
    expect(drawn().boxes[0]?.heading_deg).toBe(90);
    expect(store.selected.value).toBe(id);
  });

  test("that is called off leaves everything as it was", () => {
    store.choose("wall");
    store.grip({}, { x: 0, y: 0 });
    store.drag({ x: 2, y: 0 }, false);
    store.cancel();
    expect(store.shown.value.objects).toHaveLength(4);
    expect(saved).toEqual([]);
  });
});

describe("the way back", () => {
  test("leads through every change and forth again", () => {
    const before = drawn();
    store.choose("box");
    drag([0, 0], [1, 1]);
    store.remove();
    store.undo();
    expect(drawn().boxes).toHaveLength(1);
    store.undo();
    expect(drawn()).toEqual(before);
    expect(store.canUndo.value).toBe(false);
    store.redo();
    expect(drawn().boxes).toHaveLength(1);
    expect(store.canRedo.value).toBe(true);
  });

  test("takes a held arrow key for one change", () => {
    store.choose("box");
    tap(0, 0);
    for (let press = 0; press < 5; press++) store.nudge(0.1, 0);
    expect(drawn().boxes[0]?.center).toEqual([0.5, 0]);
    store.undo();
    expect(drawn().boxes[0]?.center).toEqual([0, 0]);
  });

  test("ends where a new change begins", () => {
    store.choose("box");
    tap(0, 0);
    store.undo();
    tap(1, 1);
    expect(store.canRedo.value).toBe(false);
  });

  test("is kept too: what is shown is what is saved", () => {
    store.choose("box");
    tap(0, 0);
    store.undo();
    expect(saved.at(-1)).toEqual(drawn());
  });

  test("brings back the world whose place another has taken", () => {
    const other = new EditorStore(
      EMPTY,
      (world) => saved.push(world),
      obstacles as unknown as World,
    );
    other.undo();
    expect(other.document.value.boxes).toHaveLength(3);
  });

  test("undoes a file that was opened", () => {
    const before = drawn();
    store.replace(obstacles as unknown as World);
    expect(drawn().boxes).toHaveLength(3);
    store.undo();
    expect(drawn()).toEqual(before);
  });
});

test("the copy of a thing lies beside it and is held", () => {
  store.choose("box");
  tap(0, 0);
  store.double();
  expect(drawn().boxes.map(({ center }) => center)).toEqual([
    [0, 0],
    [0.2, -0.2],
  ]);
  store.remove();
  expect(drawn().boxes).toHaveLength(1);
});

test("a colour dips what is held and what is drawn next", () => {
  store.choose("paint");
  tap(0, 0);
  store.setPaint("green");
  tap(2, 2);
  expect(drawn().floor.map(({ color }) => color)).toEqual(["green", "green"]);
});
