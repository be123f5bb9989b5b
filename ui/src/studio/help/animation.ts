import type { GoalPicture, World } from "../../api/model";
import type { BlockType } from "../../blocks/definitions";
import films from "./films.json";

/** x and y in metres, heading in degrees without jumps at 180; start frame. */
type AnimationPose = readonly [x: number, y: number, heading: number];

/** The robot's motion at a block, which `python -m scripts.reference` recorded in the simulator. */
export interface BlockAnimation {
  /** Duration in robot time, seconds. */
  readonly seconds: number;
  readonly poses: readonly AnimationPose[];
  /** Strokes of the pen: indices of the first and last pose with the pen down. */
  readonly strokes: readonly { color: string; from: number; to: number }[];
  readonly walls: World["walls"];
}

/** The animation of a block; null for a block that does not move the robot. */
export function animationOf(type: BlockType): BlockAnimation | null {
  return (films as unknown as Partial<Record<BlockType, BlockAnimation>>)[type] ?? null;
}

/** Maximum duration of an animation on the screen. */
const MAX_DURATION_S = 4;

/** Duration of an animation on the screen, seconds. */
export const screenSeconds = ({ seconds }: BlockAnimation): number =>
  Math.min(seconds, MAX_DURATION_S);

/** The interpolated pose at a fraction of the animation, 0 to 1. */
export function poseAt({ poses }: BlockAnimation, part: number): AnimationPose {
  const at = part * (poses.length - 1);
  const before = poses[Math.floor(at)] ?? [0, 0, 0];
  const after = poses[Math.ceil(at)] ?? before;
  const between = (axis: 0 | 1 | 2) => before[axis] + (after[axis] - before[axis]) * (at % 1);
  return [between(0), between(1), between(2)];
}

/** The path between two poses, up to a fraction of the animation, 0 to 1. */
export function driven(
  animation: BlockAnimation,
  part: number,
  from = 0,
  to = Number.POSITIVE_INFINITY,
) {
  const last = Math.min(to, part * (animation.poses.length - 1));
  if (last <= from) return [];
  const whole = animation.poses.slice(from, Math.floor(last) + 1);
  return [...whole, poseAt(animation, last / (animation.poses.length - 1))].map(
    ([x, y]) => [x, y] as const,
  );
}

const SIDE_M = 12;

/** The animation as a goal, for `GoalPicture`: the whole path fits on its floor. */
export function floorOf({ poses, walls }: BlockAnimation): GoalPicture {
  const points = poses.map(([x, y]): [number, number] => [x, y]);
  const world = {
    pinel_world: 1,
    name: "film",
    title: "film",
    size_m: [SIDE_M, SIDE_M],
    start: { x_m: 0, y_m: 0, heading_deg: 0 },
    walls,
    boxes: [],
    zones: [],
    floor: [],
    ground: null,
    prints: [],
  } as World;
  return { world, lines: [{ points, color: null, sign: null }], zones: [], boxes: {} };
}
