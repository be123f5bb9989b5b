import { effect, type ReadonlySignal } from "@preact/signals";
import { ROW_TICKS } from "./output";
import type { RunView } from "./reducer";

/** How long a beep is seen, in real time whatever the speed. One sign at most begins in this time: nothing flashes. */
export const SIGN_MS = 1200;

/** Beeps longer ago than this, in ticks of the robot, were passed over: somebody moved to another moment of a run. */
const PASSED_TICKS = 90;

/**
 * Tells how many beeps in a row are to be seen now, 0 for none. Returns the function that ends it.
 *
 * @param isStill - a moment of a recording is looked at: its beeps are seen for as long as it is. Tracked as a signal.
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
