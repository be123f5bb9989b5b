import { expect, test } from "vitest";
import { NO_CLASS } from "../api/classes";
import type { Classroom, Group } from "../api/model";
import { groupsIn, shownClass } from "./classroom";

const classes = ["a", "b"].map((id) => ({ id }) as Classroom);
const group = (id: string, classroom_id: string | null) => ({ id, classroom_id }) as Group;

test("the class last chosen is shown while it is there", () => {
  expect(shownClass("b", classes, [group("1", "a")])).toBe("b");
  expect(shownClass(NO_CLASS, classes, [group("1", "a"), group("2", null)])).toBe(NO_CLASS);
  expect(shownClass("gone", classes, [])).toBe("a");
  expect(shownClass(NO_CLASS, classes, [group("1", "b")])).toBe("b");
});

test("without a choice it is the class of the group used last, else the first", () => {
  expect(shownClass(null, classes, [group("1", null), group("2", "b")])).toBe("b");
  expect(shownClass(null, classes, [])).toBe("a");
  expect(shownClass(null, [], [])).toBe(NO_CLASS);
});

test("groups without a class are not lost", () => {
  const groups = [group("1", "a"), group("2", null)];
  expect(groupsIn("a", groups).map(({ id }) => id)).toEqual(["1"]);
  expect(groupsIn(NO_CLASS, groups).map(({ id }) => id)).toEqual(["2"]);
});
