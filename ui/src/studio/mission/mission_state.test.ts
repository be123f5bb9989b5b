import { expect, test } from "vitest";
import { marksOf } from "./mission_state";

const MET = { state: "met" } as const;

test("a further case that fails is a mark of its own: the count of a mission that is not passed is never full", () => {
  const watched = { given: "B", passed: true, seen: true };
  const other = { given: "A", passed: false, seen: false };
  expect(marksOf([MET, MET, MET], { cases: [watched, other] })).toEqual([
    "met",
    "met",
    "met",
    "broken",
  ]);
});

test("without a verdict there is a mark for each check", () => {
  expect(marksOf([MET, { state: "open" }], null)).toEqual(["met", "open"]);
});
