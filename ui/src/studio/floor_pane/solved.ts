import { type ReadonlySignal, useComputed } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { verdictOf } from "../../run/judgement";
import * as robot from "../../run/live";
import { playSound } from "../../run/sounds/sound";
import { judged } from "../../shell/session";
import type { StudioControl } from "../studio_control";

/**
 * The run on the floor if it has solved its mission, else null. Plays the fanfare, once for each such run that is judged
 * while the studio is open.
 */
export function useSolved(control: StudioControl): ReadonlySignal<string | null> {
  const solved = useComputed(() => {
    const { run } = robot.live.value;
    return control.mine.value && verdictOf(run, judged.value)?.passed ? run : null;
  });
  useEffect(() => {
    let last = solved.peek();
    return solved.subscribe((run) => {
      if (run !== null && run !== last) playSound("success");
      last = run;
    });
  }, [solved]);
  return solved;
}
