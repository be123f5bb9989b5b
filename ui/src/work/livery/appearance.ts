import { GROUP_COLORS, ROBOT_PATTERNS } from "../../api/declared";
import type { Group } from "../../api/model";
import { PICTURE_NAMES } from "../../kit/pictures/pictures";

/** What a group chooses for itself and its robot, besides its name. */
export type Appearance = Pick<Group, "color" | "picture" | "robot_name" | "robot_pattern">;

/**
 * The appearance proposed to a new group: the first colour, picture and pattern that fewest groups of its class have.
 * Of equally rare patterns, the first that none of them has in this colour. The server proposes the same.
 */
export function freeAppearance(others: readonly Appearance[]): Appearance {
  const color = rarest(GROUP_COLORS, (one) => others.filter((other) => other.color === one).length);
  const picture = rarest(
    PICTURE_NAMES,
    (one) => others.filter((other) => other.picture === one).length,
  );
  const robot_pattern = rarest(ROBOT_PATTERNS, (one) => {
    const alike = others.filter((other) => other.robot_pattern === one);
    return alike.length + alike.filter((other) => other.color === color).length / 1000;
  });
  return { color, picture, robot_name: "", robot_pattern };
}

function rarest<Value>(choices: readonly Value[], uses: (value: Value) => number): Value {
  return choices.reduce((best, one) => (uses(one) < uses(best) ? one : best));
}

/** The next name after `now` that no group has; the name after `now` if all are in use. */
export function nextName(names: readonly string[], now: string, used: readonly string[]): string {
  const key = (name: string) => name.trim().toLocaleLowerCase();
  const inUse = new Set(used.map(key));
  const begin = names.findIndex((name) => key(name) === key(now)) + 1;
  const inOrder = [...names.slice(begin), ...names.slice(0, begin)];
  return inOrder.find((name) => !inUse.has(key(name))) ?? inOrder[0] ?? "";
}
