import type { GoalPicture, World } from "../../api/model";
import type { BlockType } from "../../blocks/definitions";
import films from "./films.json";

/** x and y in metres, heading in degrees without jumps; in the start frame. */
type AnimationPose = readonly [x: number, y: number, heading: number];

/** What the robot does at a block, as `python -m scripts.reference` has driven it in the simulator. */
export interface BlockAnimation {
  /** Duration in robot time. */
  readonly seconds: number;
  readonly poses: readonly AnimationPose[];
  /** The pen was down from one pose to the other. */
  readonly strokes: readonly { color: string; from: number; to: number }[];
  readonly walls: World["walls"];
}

/** The film of a block; null for one that does not move the robot. */
export function animationOf(type: BlockType): BlockAnimation | null {
  return (films as unknown as Partial<Record<BlockType, BlockAnimation>>)[type] ?? null;
}

/** A film is over after this time at the latest. */
const MAX_DURATION_S = 4;

/** Time that a film takes on the screen. */
export const screenSeconds = ({ seconds }: BlockAnimation): number =>
  Math.min(seconds, MAX_DURATION_S);

/** The pose at a part of the film from 0 to 1. */
export function poseAt({ poses }: BlockAnimation, part: number): AnimationPose {
  const at = part * (poses.length - 1);
  const before = poses[Math.floor(at)] ?? [0, 0, 0];
  const after = poses[Math.ceil(at)] ?? before;
  const between = (axis: 0 | 1 | 2) => before[axis] + (after[axis] - before[axis]) * (at % 1);
  return [between(0), between(1), between(2)];
}

/** What was driven between two poses, as far as a part of the film goes. */
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

/** The floor of a film as that of a goal, which all of its way fits on. */
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
  } as World;
  return { world, lines: [{ points, color: null, sign: null }], zones: [], boxes: {} };
}
