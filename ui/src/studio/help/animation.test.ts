import { expect, test } from "vitest";
import { definitionOf } from "../../blocks/definitions";
import { animationOf, type BlockAnimation, driven, poseAt, screenSeconds } from "./animation";
import films from "./films.json";

const FILM: BlockAnimation = {
  seconds: 12,
  poses: [
    [0, 0, 0],
    [1, 0, 0],
    [1, 0, 90],
    [1, 1, 90],
  ],
  strokes: [],
  walls: [],
};

test("a pose between two is between them", () => {
  expect(poseAt(FILM, 0)).toEqual([0, 0, 0]);
  expect(poseAt(FILM, 0.5)).toEqual([1, 0, 45]);
  expect(poseAt(FILM, 1)).toEqual([1, 1, 90]);
});

test("a line grows with the film, and a stroke from where the pen went down", () => {
  expect(driven(FILM, 0)).toEqual([]);
  expect(driven(FILM, 1 / 6).at(-1)?.[0]).toBeCloseTo(0.5);
  expect(driven(FILM, 1, 2)).toHaveLength(3);
  expect(driven(FILM, 0.5, 2)).toEqual([]);
  expect(driven(FILM, 1, 0, 1).at(-1)).toEqual([1, 0]);
});

test("no film moves for longer than five seconds", () => {
  expect(screenSeconds(FILM)).toBeLessThan(5);
});

test("each film is that of a block, and all blocks of movement of the first level have one", () => {
  for (const type of Object.keys(films)) expect(definitionOf(type as never)).toBeDefined();
  for (const type of ["move_forward", "move_backward", "turn", "stop", "repeat"] as const) {
    expect(animationOf(type)?.poses.length).toBeGreaterThan(2);
  }
  expect(animationOf("beep")).toBeNull();
});
