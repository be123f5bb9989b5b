import { cleanup, render } from "@testing-library/preact";
import { afterEach, expect, test } from "vitest";
import type { GoalPicture as Goal, World } from "../../api/model";
import { passesAxe } from "../../kit/testing/control";
import { GoalPicture } from "./GoalPicture";
import { HEIGHT, viewportOfGoal, WIDTH } from "./goal_viewport";

const WORLD: World = {
  pinel_world: 1,
  name: "w",
  title: "w",
  size_m: [8, 6],
  start: { x_m: 0, y_m: 0, heading_deg: 90 },
  walls: [{ from: [-4, -3], to: [4, -3] }],
  boxes: [],
  zones: [],
  floor: [],
  ground: null,
  prints: [],
};
const goal = (more: Partial<Goal>): Goal => ({
  world: WORLD,
  lines: [],
  zones: [],
  boxes: {},
  ...more,
});
const line = (
  points: [number, number][],
  color: string | null = null,
  sign: string | null = null,
) => ({
  points,
  color,
  sign,
});
const drawn = (one: Goal, name: string) =>
  render(<GoalPicture goal={one} label="Um quadrado" />).container.querySelectorAll(
    `.goal__${name}`,
  );

afterEach(cleanup);

test("all of the goal lies in the picture, upright and in proportion", () => {
  const { toPixels, scale } = viewportOfGoal(
    goal({
      lines: [
        line([
          [0, 0],
          [3, 0],
          [3, 2],
        ]),
      ],
    }),
  );
  const [{ x: x0, y: y0 }, { x: x1, y: y1 }] = [toPixels({ x: 0, y: 0 }), toPixels({ x: 3, y: 2 })];
  expect(x1 - x0).toBeCloseTo(3 * scale, 0);
  expect(y0 - y1).toBeCloseTo(2 * scale, 0);
  for (const x of [x0, x1]) expect(x > 0 && x < WIDTH).toBe(true);
  for (const y of [y0, y1]) expect(y > 0 && y < HEIGHT).toBe(true);
});

test("a path has arrows: on its first stretch, and at its end unless it returns", () => {
  expect(
    drawn(
      goal({
        lines: [
          line([
            [0, 0],
            [1, 0],
          ]),
        ],
      }),
      "arrow",
    ),
  ).toHaveLength(1);
  cleanup();
  expect(
    drawn(
      goal({
        lines: [
          line([
            [0, 0],
            [1, 0],
            [1, 1],
          ]),
        ],
      }),
      "arrow",
    ),
  ).toHaveLength(2);
  cleanup();
  expect(
    drawn(
      goal({
        lines: [
          line([
            [0, 0],
            [1, 0],
            [1, 1],
            [0, 0],
          ]),
        ],
      }),
      "arrow",
    ),
  ).toHaveLength(1);
});

test("what the pen draws has its colour and no arrows", () => {
  const lines = [
    line(
      [
        [0, 0],
        [1, 0],
      ],
      "red",
    ),
  ];
  expect(drawn(goal({ lines }), "arrow")).toHaveLength(0);
  cleanup();
  const [stroke] = drawn(goal({ lines }), "line");
  expect(stroke?.parentElement?.getAttribute("style")).toContain("#d7281f");
});

test("a line says which sign it answers", () => {
  const lines = [
    line(
      [
        [0, 0],
        [1, 0],
      ],
      null,
      "B",
    ),
    line(
      [
        [0, 0],
        [0, 1],
      ],
      null,
      "A",
    ),
  ];
  expect([...drawn(goal({ lines }), "letter")].map(({ textContent }) => textContent)).toEqual([
    "B",
    "A",
  ]);
});

test("zones that count are marked: by a flag where neither a name nor a line tells", () => {
  const zone = (name: string) =>
    ({ name, center: [1, 1], size: [1, 1], heading_deg: 0 }) as World["zones"][number];
  const world = { ...WORLD, zones: [zone("A"), zone("B"), zone("meta")] };
  const one = goal({ world, zones: ["A", "meta"] });
  expect(drawn(one, "zone--wanted")).toHaveLength(2);
  cleanup();
  expect(drawn(one, "flag")).toHaveLength(1);
  cleanup();
  expect(
    drawn(
      {
        ...one,
        lines: [
          line([
            [0, 0],
            [1, 1],
          ]),
        ],
      },
      "flag",
    ),
  ).toHaveLength(0);
  cleanup();
  expect([...drawn(one, "name")].map(({ textContent }) => textContent)).toEqual(["A", "B"]);
});

test("a box is drawn where it stands and where it is to be", () => {
  const box = { center: [0, 1], size: [0.5, 0.5], heading_deg: 0, movable: true, mass_kg: 2 };
  const one = goal({
    world: { ...WORLD, boxes: [box as World["boxes"][number]] },
    boxes: { "0": [2, 1, 0] },
  });
  expect(drawn(one, "box")).toHaveLength(2);
  cleanup();
  expect(drawn(one, "box--wanted")).toHaveLength(1);
});

test("it is read aloud with its label, and passed over without one", async () => {
  const { container } = render(<GoalPicture goal={goal({})} label="Um quadrado" />);
  expect(container.querySelector("svg")?.getAttribute("aria-label")).toBe("Um quadrado");
  await passesAxe(container);
  cleanup();
  const unlabelled = render(<GoalPicture goal={goal({})} />).container.querySelector("svg");
  expect(unlabelled?.getAttribute("aria-hidden")).toBe("true");
});
