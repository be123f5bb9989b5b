import { signal } from "@preact/signals";

/** Whether predictions are drawn over real runs. */
export const isPredictionShown = signal(true);
