import { beforeEach, expect, test } from "vitest";
import type { Group } from "../api/model";
import { level, levelInUse, setLevel } from "./level";
import { remembered } from "./remembered";
import { group } from "./session";

const enter = (id: string) => {
  group.value = { id } as Group;
};

beforeEach(() => {
  levelInUse.value = 1;
});

test("a new group starts with the first steps", () => {
  enter("group-aaaaaaaaaaaa");
  expect(level.value).toBe(1);
});

test("a group keeps what it chose, and another group on the PC is not asked to share it", () => {
  enter("group-aaaaaaaaaaaa");
  setLevel(3);
  expect(level.value).toBe(3);
  enter("group-bbbbbbbbbbbb");
  expect(level.value).toBe(1);
  setLevel(2);
  enter("group-aaaaaaaaaaaa");
  expect(level.value).toBe(3);
  expect(remembered("pinel_levels")).toBe("bbbbbbbbbbbb_2_aaaaaaaaaaaa_3");
});

test("a program with blocks of a higher level opens in that level, unless the group chose another", () => {
  enter("group-cccccccccccc");
  levelInUse.value = 2;
  expect(level.value).toBe(2);
  setLevel(1);
  levelInUse.value = 3;
  expect(level.value).toBe(1);
});

test("the choices of many groups stay short enough for a cookie", () => {
  for (let number = 0; number < 60; number++) {
    enter(`group-${String(number).padStart(12, "0")}`);
    setLevel(2);
  }
  expect(remembered("pinel_levels")?.length).toBeLessThan(1000);
  expect(level.value).toBe(2);
});
