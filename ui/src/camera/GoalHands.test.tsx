import { cleanup, render } from "@testing-library/preact";
import { afterEach, expect, test } from "vitest";
import type { GoalPicture } from "../api/model";
import { GoalHands } from "./GoalHands";

afterEach(cleanup);

const goalOf = (...signs: (string | null)[]) =>
  ({ lines: signs.map((sign) => ({ sign, color: null, points: [] })) }) as unknown as GoalPicture;
const hands = (...signs: (string | null)[]) =>
  [...render(<GoalHands goal={goalOf(...signs)} />).container.querySelectorAll("[data-sign]")].map(
    (one) => one.textContent,
  );

test("each sign that decides has its hand once, and a number or a goal without signs has none", () => {
  expect(hands("B", "A", "B")).toEqual(["B", "A"]);
  expect(hands("3", null)).toEqual([]);
});
