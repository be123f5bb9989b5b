import { DEFAULT_ROBOT, DEFAULT_WORLD } from "../../api/declared";
import { OWN_WORLD, type RealismOptions, type Setup, type Version } from "../../api/model";

/** Speed factors of the simulated robot. */
export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10] as const;

/** Choices of preset and feedback. */
export const REALISM_PRESETS = {
  ideal: { preset: "ideal", feedback: "pose" },
  camera: { preset: "realistic", feedback: "pose" },
  wheels: { preset: "realistic", feedback: "odometry" },
} as const satisfies Record<string, RealismOptions>;

export type RealismName = keyof typeof REALISM_PRESETS;

/** The setup of a version. A version of an earlier release has no setup: its own world, else defaults. */
export function setupOf(version: Pick<Version, "setup" | "world"> | null): Setup {
  const world = version?.world ? OWN_WORLD : DEFAULT_WORLD;
  return (
    version?.setup ?? {
      model: DEFAULT_ROBOT,
      ...REALISM_PRESETS.ideal,
      calibrated_robot: null,
      world,
      start: null,
      speed: 1,
      activity: null,
      n_hints: 0,
    }
  );
}

/** The page's name for the preset and feedback of a setup. */
export function realismOf({ preset, feedback }: Setup): RealismName {
  if (preset === "ideal") return "ideal";
  return feedback === "pose" ? "camera" : "wheels";
}
