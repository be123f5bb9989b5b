import type { Robot, RunPrediction, World } from "../api/model";
import type { Stretch } from "../run/playback";
import { IDLE } from "../run/reducer";
import type { Trail } from "../run/trail";
import type { Companion } from "../scene/companion";
import { predictedPose, predictedTick, predictedTrail, stepsOf } from "./predicted_path";

interface Beside {
  readonly prediction: RunPrediction;
  readonly world: World | null;
  readonly robot: Robot | null;
  /** The blocks of the real run so far. */
  readonly stretches: readonly Stretch[];
  readonly tick: number;
}

const trails = new WeakMap<RunPrediction, Trail>();

/** The predicted robot beside the real one, with its whole path. */
export function ghostOf({ prediction, world, robot, stretches, tick }: Beside): Companion {
  const trail = trails.get(prediction) ?? predictedTrail(prediction.path);
  trails.set(prediction, trail);
  const pose = predictedPose(prediction.path, predictedTick(prediction, stepsOf(stretches), tick));
  return {
    world,
    robot,
    livery: null,
    view: { ...IDLE, path: trail },
    pose: () => pose,
  };
}

/** Adds the path that a camera or the robot's localisation saw, which is also shown without a ghost. */
export function withMeasured(
  ghost: Companion | null,
  measured: Companion["measured"],
  world: World | null,
): Companion | null {
  if (!measured) return ghost;
  if (ghost) return { ...ghost, measured };
  return { world, robot: null, livery: null, view: IDLE, measured, pose: () => IDLE.pose };
}
