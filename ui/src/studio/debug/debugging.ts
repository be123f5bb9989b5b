import { computed, effect, signal, untracked } from "@preact/signals";
import * as robot from "../../run/live";
import { level } from "../../shell/level";
import type { OpenProgram } from "../program/open_program";
import { REALISM_PRESETS } from "../program/setup";

/** Ids of the blocks of the open program before which the run pauses. */
export const breakpoints = signal<readonly string[]>([]);

/** The options with which a new run of a program starts. */
export function runSettings({ setup }: OpenProgram, paused: boolean): robot.RunOptions {
  const { model, preset, feedback, calibrated_robot, speed } = setup.peek();
  // on the first level the choice is hidden, so an earlier choice must not apply
  const chosen =
    level.peek() > 1 ? { model, preset, feedback, calibrated_robot } : REALISM_PRESETS.ideal;
  return { breakpoints: [...breakpoints.peek()], speed, paused, ...chosen };
}

/** Sends changes of breakpoints and speed to the live run; returns the unsubscribe function. */
export function syncRunSettings(open: OpenProgram, report: (error: unknown) => void): () => void {
  let first = true;
  const speed = computed(() => open.setup.value.speed);
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
