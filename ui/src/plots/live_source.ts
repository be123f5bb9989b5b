import { computed, signal } from "@preact/signals";
import { record } from "../run/live_record";
import { program } from "../shell/session";
import type { PlotSource } from "./plot_source";

const pointed = signal<number | null>(null);

/** Samples of the live run for the plots of the studio. */
export const liveSource: PlotSource = {
  get samples() {
    return record.samples;
  },
  get stretches() {
    return record.stretches;
  },
  revision: record.revision,
  moment: computed(() => pointed.value),
  input: {
    onPoint: (tick) => {
      pointed.value = tick;
    },
    onPress: (tick) => {
      pointed.value = tick;
    },
  },
  name: () => program.peek()?.name ?? "",
};
