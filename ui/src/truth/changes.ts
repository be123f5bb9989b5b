import { computed, signal } from "@preact/signals";
import { recordedTruths } from "../run/real/truth_sources";

const typed = signal(0);

/** Counts what was recorded about where robots truly were: what is computed from it is then asked for again. */
export const truthChanges = computed(() => typed.value + recordedTruths.value);

/** A person has typed a measurement. */
export function countTyped(): void {
  typed.value += 1;
}
