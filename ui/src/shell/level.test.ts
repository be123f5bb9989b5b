import { beforeEach, expect, test } from "vitest";
import type { Group } from "../api/model";
import { level, levelInUse, levelOfClass, missionLevel, offered, setLevel, shown } from "./level";
import { group } from "./session";
import { setting } from "./settings";

const enter = (id: string) => {
  group.value = { id } as Group;
};

beforeEach(() => {
  levelInUse.value = 1;
  missionLevel.value = null;
  levelOfClass.value = null;
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
  expect(setting("pinel_levels").value).toBe("bbbbbbbbbbbb_2_aaaaaaaaaaaa_3");
});

test("a program with blocks of a higher level opens in that level, unless the group chose another", () => {
  enter("group-cccccccccccc");
  levelInUse.value = 2;
  expect(level.value).toBe(2);
  setLevel(1);
  levelInUse.value = 3;
  expect(level.value).toBe(1);
});

test("the choices of many groups stay short", () => {
  for (let number = 0; number < 60; number++) {
    enter(`group-${String(number).padStart(12, "0")}`);
    setLevel(2);
  }
  expect(setting("pinel_levels").value.length).toBeLessThan(1000);
  expect(level.value).toBe(2);
});

test("a mission opens in its level, and what the group chooses there holds for its program alone", () => {
  enter("group-dddddddddddd");
  setLevel(3);
  const mission = (program: string) => ({ program, level: 2, blocks: null }) as const;
  missionLevel.value = mission("program-aaaaaaaaaaaa");
  expect(level.value).toBe(2);
  setLevel(1);
  expect(level.value).toBe(1);
  missionLevel.value = mission("program-bbbbbbbbbbbb");
  expect(level.value).toBe(2);
  missionLevel.value = null;
  expect(level.value).toBe(3);
  missionLevel.value = mission("program-aaaaaaaaaaaa");
  expect(level.value).toBe(1);
  expect(setting("pinel_mission_levels").value).toBe("aaaaaaaaaaaa_1");
});

test("a mission that lists its blocks offers only those, until the group chooses a level", () => {
  const blocks = ["move_forward", "turn"];
  missionLevel.value = { program: "program-cccccccccccc", level: 1, blocks };
  expect([shown.value, level.value, offered.value]).toEqual(["mission", 1, blocks]);
  setLevel(2);
  expect([shown.value, level.value, offered.value]).toEqual([2, 2, null]);
  setLevel(1);
  expect([shown.value, offered.value]).toEqual([1, null]);
  setLevel("mission");
  expect([shown.value, offered.value]).toEqual(["mission", blocks]);
});

test("a mission without a level has that of the blocks in use, or what it lists out of all", () => {
  levelInUse.value = 2;
  missionLevel.value = { program: "program-dddddddddddd", level: null, blocks: null };
  expect(level.value).toBe(2);
  missionLevel.value = { program: "program-dddddddddddd", level: null, blocks: ["drive"] };
  expect([level.value, offered.value]).toEqual([3, ["drive"]]);
});

test("a group that chose no level begins with that of its class, and may change it", () => {
  enter("group-eeeeeeeeeeee");
  levelOfClass.value = 2;
  expect(level.value).toBe(2);
  levelInUse.value = 3;
  expect(level.value).toBe(3);
  setLevel(1);
  expect(level.value).toBe(1);
});
