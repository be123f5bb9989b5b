import { beforeEach, expect, test } from "vitest";
import type { Group, RealRobot } from "../../api/model";
import { group } from "../../shell/session";
import {
  chooseRobot,
  chosenRobot,
  isChecked,
  realRobots,
  robotHasRun,
  robotOfRun,
} from "./real_robot";

beforeEach(() => {
  realRobots.value = [{ link: "bridge", is_set_up: true } as RealRobot];
  group.value = { id: "tatus" } as Group;
  chooseRobot("bridge");
  isChecked.value = true;
  robotHasRun();
});

test("the group that chose a robot keeps it while its name or its program changes", () => {
  group.value = { id: "tatus", name: "Tatus" } as Group;
  expect(robotOfRun()).toEqual({ robot: "bridge", slow: false });
  expect(isChecked.value).toBe(true);
});

test.each([
  ["another group", { id: "araras" } as Group],
  ["nobody", null],
])("%s begins with the simulator, the check list and a slow run", (_, next) => {
  group.value = next;
  expect(chosenRobot.value).toBeNull();
  expect(robotOfRun()).toEqual({});
  chooseRobot("bridge");
  expect(isChecked.value).toBe(false);
  expect(robotOfRun()).toEqual({ robot: "bridge", slow: true });
});
