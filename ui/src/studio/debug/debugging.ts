import { effect, signal, untracked } from "@preact/signals";
import type { Lifelike } from "../../api/model";
import * as robot from "../../run/live";
import { level } from "../../shell/level";

/** Speed factors of the simulated robot. */
export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10] as const;

export const speed = signal<number>(1);

/** Choices of preset and feedback for the next run. */
export const LIFELIKE = {
  ideal: { preset: "ideal", feedback: "pose" },
  camera: { preset: "realistic", feedback: "pose" },
  wheels: { preset: "realistic", feedback: "odometry" },
} as const satisfies Record<string, Lifelike>;

export const lifelike = signal<keyof typeof LIFELIKE>("ideal");

/** Ids of the blocks of the open program before which the run pauses. */
export const breakpoints = signal<readonly string[]>([]);

/** The settings that a new run begins with. */
export function runSettings(paused: boolean): robot.Debugging {
  // on the first level the choice is hidden, so an earlier choice must not apply
  const chosen = LIFELIKE[level.peek() > 1 ? lifelike.peek() : "ideal"];
  return { breakpoints: [...breakpoints.peek()], speed: speed.peek(), paused, ...chosen };
}

/** Sends changes of these settings to the live run; returns the unsubscribe function. */
export function tellRun(report: (error: unknown) => void): () => void {
  let first = true;
  const stops = [
    effect(() => {
      const blocks = [...breakpoints.value];
      if (!first) untracked(() => robot.command({ do: "breakpoints", blocks }).catch(report));
    }),
    effect(() => {
      const factor = speed.value;
      if (!first) untracked(() => robot.command({ do: "speed", factor }).catch(report));
    }),
  ];
  first = false;
  return () => {
    for (const stop of stops) stop();
  };
}
