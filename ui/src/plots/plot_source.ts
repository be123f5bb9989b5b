import type { ReadonlySignal } from "@preact/signals";
import type { Stretch } from "../run/playback";
import type { Samples } from "../run/samples";
import type { PlotInput } from "./chart";

/** The measurements of a run, live or recorded, and the selected tick. */
export interface PlotSource {
  readonly samples: Samples;
  readonly stretches: readonly Stretch[];
  /** Changes when there are new samples to draw. */
  readonly revision: ReadonlySignal<number>;
  /** The selected tick; null if no tick is selected. */
  readonly selectedTick: ReadonlySignal<number | null>;
  readonly input: PlotInput;
  /** Name of the program. */
  name(): string;
}
