import { effect, type ReadonlySignal } from "@preact/signals";
import { ROW_TICKS } from "./output";
import type { RunView } from "./reducer";

/**
 * Real time for which the sign of a beep is shown, at any speed of the run. At most one sign
 * appears in this time, so the sign does not flash.
 */
export const SIGN_MS = 1200;

/** Older beeps, in ticks of the robot, are not shown: somebody moved the replay past them. */
const PASSED_TICKS = 90;

/**
 * Calls `show` with the number of consecutive beeps to draw now, 0 for none. Returns the function
 * that ends the calls.
 *
 * @param isStill - whether the view shows one tick of a recorded run. The beeps of such a tick
 * are shown as long as the tick is. Tracked as a signal.
 */
export function showBeeps(
  view: ReadonlySignal<RunView>,
  isStill: () => boolean,
  show: (beeps: number) => void,
): () => void {
  let run: string | null = null;
  let known = 0;
  let passing = 0;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const end = () => {
    clearTimeout(timer);
    passing = 0;
  };
  const stop = effect(() => {
    const still = isStill();
    const { tick, output, ...now } = view.value;
    const { beeps } = output;
    const newBeeps = now.run === run ? beeps.count - known : 0;
    if (newBeeps < 0 || now.run !== run) end();
    else if (newBeeps > 0 && !still && tick - beeps.tick < PASSED_TICKS) {
      const before = passing;
      end();
      passing = before + Math.min(newBeeps, beeps.inRow);
      timer = setTimeout(() => {
        end();
        show(beepsAtTick(view.peek(), isStill()));
      }, SIGN_MS);
    }
    run = now.run;
    known = beeps.count;
    show(beepsAtTick(view.value, still) || passing);
  });
  return () => {
    stop();
    end();
  };
}

function beepsAtTick({ tick, output: { beeps } }: RunView, still: boolean): number {
  return still && beeps.count > 0 && tick - beeps.tick < ROW_TICKS ? beeps.inRow : 0;
}
