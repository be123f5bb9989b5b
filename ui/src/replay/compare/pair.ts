import { computed, type ReadonlySignal } from "@preact/signals";
import type { Playback } from "../../run/playback";
import type { Pose, RunView } from "../../run/reducer";
import { needsRepair, type RecordedRun } from "../recorded_run";

/** One of two runs at the time of the shared clock. */
export interface Side {
  readonly recordedRun: RecordedRun;
  readonly view: ReadonlySignal<RunView>;
  readonly playing: ReadonlySignal<boolean>;
  /** Whether the clock is where the comparison was opened. */
  readonly isUntouched: ReadonlySignal<boolean>;
  /** Interpolated pose of its robot. */
  pose(): Pose;
}

/** Two runs that start together on a shared clock; the shorter one stays at its end. */
export class Pair {
  readonly sides: readonly [Side, Side];
  /** The shared clock, which belongs to the longer run. */
  readonly playback: Playback;
  constructor(first: RecordedRun, second: RecordedRun) {
    const longer = second.playback.end > first.playback.end ? second : first;
    this.playback = longer.playback;
    this.playback.stopsAtCaptures = false;
    this.playback.seek([first, second].some(needsRepair) ? this.playback.end : 0);
    this.sides = [this.sideOf(first), this.sideOf(second)];
  }

  private sideOf(recordedRun: RecordedRun): Side {
    const { playback: clock } = this;
    const { playback } = recordedRun;
    const { playing } = clock;
    const opened = clock.tick.peek();
    const isUntouched = computed(() => clock.tick.value === opened);
    const shared = { recordedRun, playing, isUntouched };
    if (playback === clock) return { ...shared, view: clock.view, pose: clock.pose };
    const { history } = playback;
    const tick = computed(() => Math.min(Math.floor(clock.tick.value), playback.end));
    return {
      ...shared,
      view: computed(() => history.at(tick.value)),
      pose: () => history.poseAt(clock.tick.peek()),
    };
  }

  dispose(): void {
    this.playback.dispose();
  }
}
