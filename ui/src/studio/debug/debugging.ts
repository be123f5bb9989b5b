import { effect, signal, untracked } from "@preact/signals";
import type { Lifelike } from "../../api/model";
import * as robot from "../../run/live";
import { level } from "../../shell/level";

/** How many times faster than a real robot the simulated one is. */
export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10] as const;

export const speed = signal<number>(1);

/** How true to life the next run is. */
export const LIFELIKE = {
  ideal: { preset: "ideal", feedback: "pose" },
  camera: { preset: "realistic", feedback: "pose" },
  wheels: { preset: "realistic", feedback: "odometry" },
} as const satisfies Record<string, Lifelike>;

export const lifelike = signal<keyof typeof LIFELIKE>("ideal");

/** Ids of the blocks before which the run pauses; of the program that is open. */
export const breakpoints = signal<readonly string[]>([]);

/** What a run is to know from its beginning. */
export function wishes(paused: boolean): robot.Debugging {
  // where nothing can be chosen, nothing that was chosen elsewhere surprises
  const chosen = LIFELIKE[level.peek() > 1 ? lifelike.peek() : "ideal"];
  return { breakpoints: [...breakpoints.peek()], speed: speed.peek(), paused, ...chosen };
}

/** Tells the live run what is changed; the answer ends that. */
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
