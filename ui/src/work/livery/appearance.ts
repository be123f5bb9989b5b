import { GROUP_COLORS, ROBOT_PATTERNS } from "../../api/declared";
import type { Group } from "../../api/model";
import { PICTURE_NAMES } from "../../kit/pictures/pictures";

/** What a group chooses for itself and its robot, besides its name. */
export type Appearance = Pick<Group, "color" | "picture" | "robot_name" | "robot_pattern">;

/**
 * The appearance proposed to a new group: the first colour, picture and pattern that fewest groups of its class have.
 * Each is counted from a place that the name gives, so that groups of several PCs seldom look alike
 * once the PCs are merged. The pattern is rather one that no group has in the same colour. The server proposes the same
 * (`storage/work/groups.py`).
 */
export function freeAppearance(
  others: readonly Appearance[],
  name: string,
  chosenColor?: string,
): Appearance {
  const number = numberOf(name);
  const count = (fits: (other: Appearance) => boolean) => others.filter(fits).length;
  const color =
    chosenColor ?? rarest(rotated(GROUP_COLORS, number), (one) => count((at) => at.color === one));
  const picture = rarest(
    rotated(PICTURE_NAMES, Math.floor(number / GROUP_COLORS.length / ROBOT_PATTERNS.length)),
    (one) => count((at) => at.picture === one),
  );
  const robot_pattern = rarest(
    rotated(ROBOT_PATTERNS, Math.floor(number / GROUP_COLORS.length)),
    (one) => {
      const alike = count((at) => at.robot_pattern === one && at.color === color);
      return 1000 * alike + count((at) => at.robot_pattern === one);
    },
  );
  return { color, picture, robot_name: "", robot_pattern };
}

function rarest<Value>(choices: readonly Value[], uses: (value: Value) => number): Value {
  return choices.reduce((best, one) => (uses(one) < uses(best) ? one : best));
}

/** A number that names rarely share; the server calculates the same. */
function numberOf(name: string): number {
  const key = name.normalize("NFKC").toLowerCase().replace(/\s/g, "");
  return [...key].reduce(
    (number, letter) => (31 * number + (letter.codePointAt(0) ?? 0)) % 1_000_003,
    0,
  );
}

function rotated<Value>(choices: readonly Value[], by: number): readonly Value[] {
  const begin = by % choices.length;
  return [...choices.slice(begin), ...choices.slice(0, begin)];
}

/** The next name after `now` that no group has; the name after `now` if all are in use. */
export function nextName(names: readonly string[], now: string, used: readonly string[]): string {
  const key = (name: string) => name.trim().toLocaleLowerCase();
  const inUse = new Set(used.map(key));
  const begin = names.findIndex((name) => key(name) === key(now)) + 1;
  const inOrder = [...names.slice(begin), ...names.slice(0, begin)];
  return inOrder.find((name) => !inUse.has(key(name))) ?? inOrder[0] ?? "";
}
