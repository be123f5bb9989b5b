import type { Language, World } from "../../api/model";
import type { Texts } from "../../i18n";
import { degrees, headingDegrees, metres } from "../../i18n/format";
import type { BoxPoses, Pose } from "../../run/reducer";
import { type Ahead, aheadOf } from "../ahead";
import { startOf, toWorld } from "../frames";
import { placeAt } from "../mark_text";

interface Shown {
  readonly world: World | null;
  readonly boxes: BoxPoses;
  /** The robot's true pose, start frame. */
  readonly truth: Pose;
  /** Radius of the robot, metres. */
  readonly radius: number;
}

/** What the floor in 3D shows, as sentences. */
export function describeFloor(
  { world, boxes, truth, radius }: Shown,
  texts: Texts,
  language: Language,
): string {
  const { solid } = texts;
  const label = solid.label({
    x: metres(truth.x, language),
    y: metres(truth.y, language),
    heading: degrees(headingDegrees(truth.yaw), language),
  });
  if (!world) return label;
  const start = startOf(world);
  const robot = { ...toWorld(start, truth.x, truth.y), yaw: start.yaw + truth.yaw };
  const place = placeAt(world, robot);
  const ahead = aheadOf(world, boxes, robot);
  return [
    label,
    place && solid.inPlace({ place }),
    ahead &&
      solid.ahead({
        distance: metres(Math.max(0, ahead.metres - radius), language),
        name: nameOf(ahead, texts),
      }),
  ]
    .filter(Boolean)
    .join(" ");
}

function nameOf({ box }: Ahead, { solid, world }: Texts): string {
  if (!box) return solid.wall;
  const name = box.kind ? world.things[box.kind] : world.plainBox;
  return name.toLowerCase();
}
