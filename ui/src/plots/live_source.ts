import { computed, signal } from "@preact/signals";
import { inspectedTick, inspectTick } from "../run/inspected_tick";
import { record } from "../run/live_record";
import { program } from "../shell/session";
import type { PlotSource } from "./plot_source";

const pointed = signal<number | null>(null);

/**
 * Samples of the live run for the plots of the studio. If the run has ended, a press on a plot
 * shows the run at that tick.
 */
export const liveSource: PlotSource = {
  get samples() {
    return record.samples;
  },
  get stretches() {
    return record.stretches;
  },
  revision: record.revision,
  selectedTick: computed(() => pointed.value ?? inspectedTick.value?.tick ?? null),
  input: {
    onPoint: (tick) => {
      pointed.value = tick;
    },
    onPress: (tick) => {
      pointed.value = tick;
      inspectTick(tick);
    },
  },
  name: () => program.peek()?.name ?? "",
};
