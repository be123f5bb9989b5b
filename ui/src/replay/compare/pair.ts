import { computed, type ReadonlySignal } from "@preact/signals";
import type { Playback } from "../../run/playback";
import type { Pose, RunView } from "../../run/reducer";
import type { RecordedRun } from "../recorded_run";

/** One of two runs at the time of the shared clock. */
export interface Side {
  readonly recordedRun: RecordedRun;
  readonly view: ReadonlySignal<RunView>;
  readonly playing: ReadonlySignal<boolean>;
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
    this.sides = [this.sideOf(first), this.sideOf(second)];
  }

  private sideOf(recordedRun: RecordedRun): Side {
    const { playback: clock } = this;
    const { playback } = recordedRun;
    const { playing } = clock;
    if (playback === clock) return { recordedRun, playing, view: clock.view, pose: clock.pose };
    const { history } = playback;
    const tick = computed(() => Math.min(Math.floor(clock.tick.value), playback.end));
    return {
      recordedRun,
      playing,
      view: computed(() => history.at(tick.value)),
      pose: () => history.poseAt(clock.tick.peek()),
    };
  }

  dispose(): void {
    this.playback.dispose();
  }
}
