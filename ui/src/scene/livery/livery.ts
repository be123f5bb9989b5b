import type { Group, Robot } from "../../api/model";
import type { Colours } from "../colours";
import { extentOf } from "../hull";
import { mixed } from "../mat/parts";
import { contrast } from "../paints";
import { type Pattern, patternOf } from "./patterns";

/** What a group chose for its robot. Canvas, small pictures and 3D draw the robot with it. */
export interface Livery {
  /** Its colour as #rrggbb. */
  readonly colour: string;
  /** Its pattern, by the name in `patterns.ts`. */
  readonly pattern: string;
  /** Its name, which stands beside it. */
  readonly name: string;
}

/** The colours of the hull on a floor. */
export interface LiveryPaint {
  readonly body: string;
  /** The drawing on the hull, and its colour; null for a plain hull. */
  readonly pattern: { readonly drawing: Pattern; readonly colour: string } | null;
}

/** The body differs from both tiles of the floor at least so much: WCAG 2.2, 1.4.11. */
export const MIN_CONTRAST = 3;
/** Share of white or black that each step adds to a colour, until its contrast suffices. */
const STEP = 0.04;
/** Share of the pattern's colour that is white on a dark body, or black on a light one. */
const PATTERN_PART = 0.78;

/** The livery of a group; null without a group, for which the robot has its own colour. */
export function liveryOf(
  group: Pick<Group, "name" | "color" | "robot_name" | "robot_pattern"> | null | undefined,
): Livery | null {
  if (!group) return null;
  const { color: colour, robot_pattern: pattern, robot_name: name } = group;
  return { colour, pattern, name: name || group.name };
}

/** The colours of a robot on the floor of a theme. High contrast has no liveries, as it has no prints. */
export function liveryPaint(livery: Livery | null, colours: Colours): LiveryPaint {
  if (!livery || Number(colours.print) === 0) return { body: colours.robot, pattern: null };
  const body = bodyColour(livery.colour, colours);
  const drawing = patternOf(livery.pattern);
  return { body, pattern: drawing && { drawing, colour: patternColour(body) } };
}

/** The group's colour, lighter on a dark floor and darker on a light one until it stands out from its tiles. */
function bodyColour(colour: string, { tile, otherTile }: Colours): string {
  const towards = isDark(tile) ? "#ffffff" : "#000000";
  const isVisible = (one: string) =>
    Math.min(contrast(one, tile), contrast(one, otherTile)) >= MIN_CONTRAST;
  for (let part = 0; part < 1; part += STEP) {
    const body = mixed(colour, towards, part);
    if (isVisible(body)) return body;
  }
  return towards;
}

function patternColour(body: string): string {
  return mixed(body, isDark(body) ? "#ffffff" : "#000000", PATTERN_PART);
}

/** Whether white stands out on a colour, which is preferred to black. */
function isDark(colour: string): boolean {
  return contrast(colour, "#ffffff") > contrast(colour, "#000000") / 1.6;
}

/** Where the unit square of the patterns lies on a hull: its centre, and the length of its unit in metres. */
export function patternFrame(robot: Pick<Robot, "hull_m">): { x: number; unit: number } {
  const { back, length, width } = extentOf(robot);
  return { x: back + length / 2, unit: Math.max(length, width) / 2 };
}
