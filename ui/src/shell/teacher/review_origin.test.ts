import { expect, test } from "vitest";
import type { Route } from "../route";
import { nextOrigin } from "./review_origin";

const LESSON = { screen: "lesson", lesson: "l1" } as const;
const REPLAY = { screen: "replay", run: "r1" } as const;

function walk(...screens: Route[]) {
  return screens.reduce<ReturnType<typeof nextOrigin>>((last, now) => nextOrigin(now, last), null);
}

test("who opens a run from the lesson's page can go back to it, over another version too", () => {
  expect(walk(LESSON, REPLAY)).toEqual(LESSON);
  const history = { screen: "versions", program: "p1", version: null } as const;
  expect(walk(LESSON, history, REPLAY)).toEqual(LESSON);
});

test("the way back is to the last of the two pages", () => {
  expect(walk(LESSON, { screen: "runs" }, REPLAY)).toEqual({ screen: "runs" });
});

test("who came from the pupils' side has no way back to the review", () => {
  expect(walk(LESSON, { screen: "start" }, { screen: "work", group: "g1" }, REPLAY)).toBeNull();
  expect(walk(REPLAY)).toBeNull();
  expect(walk(LESSON, { screen: "studio", program: "p1" }, REPLAY)).toBeNull();
});
