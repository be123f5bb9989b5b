import type { RunPrediction } from "../api/model";
import { between } from "../run/motion_buffer";
import type { Stretch } from "../run/playback";
import type { Pose } from "../run/reducer";
import { EMPTY_TRAIL, extend, type Trail } from "../run/trail";

/** Motions whose amount is not known before. */
const TO_A_PLACE = new Set(["go_to", "go_to_place"]);

/** The steps of a run, as the server counts them: motions and waits. */
export const stepsOf = (stretches: readonly Stretch[]): Stretch[] =>
  stretches.filter(({ action, amount }) => amount !== null || TO_A_PLACE.has(action));

/**
 * The tick of the prediction that belongs to a tick of the real run: as long after the start of the same step, and at most its end.
 * So the ghost waits after each step for the robot. It stays where the real run took another way.
 */
export function predictedTick(
  { steps, path }: Pick<RunPrediction, "steps" | "path">,
  real: readonly Stretch[],
  tick: number,
): number {
  const last = path.at(-1)?.[0] ?? 0;
  const now = real.findLastIndex(({ from }) => from <= tick);
  let reached = 0;
  for (let n = 0; n <= now; n++) {
    const [step, stretch] = [steps[n], real[n]];
    if (!step || !stretch || step.block !== stretch.block || step.action !== stretch.action) break;
    const end = n < now ? (steps[n + 1]?.start ?? last) : (step.end ?? last);
    reached = n < now ? end : Math.min(end, step.start + tick - stretch.from);
  }
  return now < 0 ? Math.min(tick, steps[0]?.start ?? last) : reached;
}

/** The predicted pose at a tick of the prediction, interpolated. */
export function predictedPose(path: RunPrediction["path"], tick: number): Pose {
  let [low, high] = [0, path.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((path[middle]?.[0] ?? 0) <= tick) low = middle + 1;
    else high = middle;
  }
  const before = path[Math.max(0, low - 1)] ?? [0, 0, 0, 0];
  const after = path[low] ?? before;
  const part = after === before ? 0 : (tick - before[0]) / (after[0] - before[0]);
  return between(poseOf(before), poseOf(after), part);
}

const poseOf = ([, x, y, yaw]: RunPrediction["path"][number]): Pose => ({ x, y, yaw });

/** The whole predicted path as a line. */
export function predictedTrail(path: RunPrediction["path"]): Trail {
  return path.reduce<Trail>((trail, [, x, y]) => extend(trail, [x, y]), EMPTY_TRAIL);
}
