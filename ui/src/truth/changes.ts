import { signal } from "@preact/signals";

/** Counts what the page has recorded about where robots truly were: what is computed from it is then asked for again. */
export const truthChanges = signal(0);
