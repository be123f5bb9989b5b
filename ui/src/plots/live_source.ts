import { computed, signal } from "@preact/signals";
import { program } from "../app/session";
import { record } from "../run/live_record";
import type { PlotSource } from "./PlotsPanel";

const pointed = signal<number | null>(null);

/** What the robot did up to now: the plots of the studio. */
export const liveSource: PlotSource = {
  get samples() {
    return record.samples;
  },
  get stretches() {
    return record.stretches;
  },
  revision: record.revision,
  moment: computed(() => pointed.value),
  hand: {
    onPoint: (tick) => {
      pointed.value = tick;
    },
    onPress: (tick) => {
      pointed.value = tick;
    },
  },
  name: () => program.peek()?.name ?? "",
};
