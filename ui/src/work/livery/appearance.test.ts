import { expect, test } from "vitest";
import { GROUP_COLORS, ROBOT_PATTERNS } from "../../api/declared";
import { type Appearance, freeAppearance, nextName } from "./appearance";

test("24 groups of a class get 24 robots that differ, the first six with six patterns", () => {
  const groups: Appearance[] = [];
  for (let n = 0; n < 24; n++) groups.push(freeAppearance(groups, `Grupo ${n}`));
  const patterns = groups.slice(0, 6).map((one) => one.robot_pattern);
  expect(new Set(patterns)).toEqual(new Set(ROBOT_PATTERNS));
  expect(new Set(groups.slice(0, 12).map((one) => one.color))).toEqual(new Set(GROUP_COLORS));
  expect(new Set(groups.map((one) => `${one.color} ${one.robot_pattern}`)).size).toBe(24);
  expect(new Set(groups.map((one) => one.picture)).size).toBe(24);
});

test("a pattern that another robot has in the same colour is proposed last, however rare it is", () => {
  const [color, other] = GROUP_COLORS;
  const robot = (its: string, robot_pattern: string): Appearance => ({
    color: its,
    picture: "",
    robot_name: "",
    robot_pattern,
  });
  const others = [
    robot(color, "waves"),
    ...ROBOT_PATTERNS.filter((one) => one !== "waves").flatMap((one) => [
      robot(other, one),
      robot(other, one),
    ]),
  ];
  expect(freeAppearance(others, "Botos", color).robot_pattern).not.toBe("waves");
});

// tests/storage/work/test_classes.py has the same table
test.each([
  ["Botos", 8, "checks"],
  ["ARARAS ", 5, "dots"],
  ["Onças", 0, "checks"],
  ["🤖", 2, "plain"],
] as const)("the name of the first group decides as on the server: %s", (name, color, pattern) => {
  const { color: proposed, robot_pattern } = freeAppearance([], name);
  expect([GROUP_COLORS.indexOf(proposed as (typeof GROUP_COLORS)[number]), robot_pattern]).toEqual([
    color,
    pattern,
  ]);
});

test("a name is proposed that no group has, and each press proposes the next", () => {
  const names = ["Botos", "Araras", "Onças"];
  expect(nextName(names, "", [])).toBe("Botos");
  expect(nextName(names, "", ["botos "])).toBe("Araras");
  expect(nextName(names, "Araras", [])).toBe("Onças");
  expect(nextName(names, "Onças", [])).toBe("Botos");
  expect(nextName(names, "Robôs", names)).toBe("Botos");
});
