import { DEFAULT_ROBOT, DEFAULT_WORLD } from "../../api/declared";
import { OWN_WORLD, type RealismOptions, type Setup, type Version } from "../../api/model";

/** Speed factors of the simulated robot. */
export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10] as const;

/** Choices of preset and feedback. */
export const LIFELIKE = {
  ideal: { preset: "ideal", feedback: "pose" },
  camera: { preset: "realistic", feedback: "pose" },
  wheels: { preset: "realistic", feedback: "odometry" },
} as const satisfies Record<string, RealismOptions>;

export type LifelikeName = keyof typeof LIFELIKE;

/** The setup of a version. A version of an earlier release has no setup: its own world, else defaults. */
export function setupOf(version: Pick<Version, "setup" | "world"> | null): Setup {
  const world = version?.world ? OWN_WORLD : DEFAULT_WORLD;
  return (
    version?.setup ?? {
      model: DEFAULT_ROBOT,
      ...LIFELIKE.ideal,
      world,
      start: null,
      speed: 1,
      activity: null,
      n_hints: 0,
    }
  );
}

/** The page's name for the preset and feedback of a setup. */
export function lifelikeOf({ preset, feedback }: Setup): LifelikeName {
  if (preset === "ideal") return "ideal";
  return feedback === "pose" ? "camera" : "wheels";
}
