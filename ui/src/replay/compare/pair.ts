import { computed, type ReadonlySignal } from "@preact/signals";
import type { Playback } from "../../run/playback";
import type { Pose, RunView } from "../../run/reducer";
import type { Recording } from "../recording";

/** One of two runs at the time of the shared clock. */
export interface Side {
  readonly recording: Recording;
  readonly view: ReadonlySignal<RunView>;
  readonly playing: ReadonlySignal<boolean>;
  /** Interpolated pose of its robot. */
  pose(): Pose;
}

/** Two runs that start together on a shared clock; the shorter one stays at its end. */
export class Pair {
  readonly sides: readonly [Side, Side];
  /** The shared clock: that of the longer run. */
  readonly playback: Playback;

  constructor(first: Recording, second: Recording) {
    const longer = second.playback.end > first.playback.end ? second : first;
    this.playback = longer.playback;
    this.sides = [this.sideOf(first), this.sideOf(second)];
  }

  private sideOf(recording: Recording): Side {
    const { playback: clock } = this;
    const { playback } = recording;
    const { playing } = clock;
    if (playback === clock) return { recording, playing, view: clock.view, pose: clock.pose };
    const { history } = playback;
    const tick = computed(() => Math.min(Math.floor(clock.tick.value), playback.end));
    return {
      recording,
      playing,
      view: computed(() => history.at(tick.value)),
      pose: () => history.poseAt(clock.tick.peek()),
    };
  }

  dispose(): void {
    this.playback.dispose();
  }
}
