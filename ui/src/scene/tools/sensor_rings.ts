import { computed, effect, signal, untracked } from "@preact/signals";
import type { Ring } from "../../api/model";
import * as robot from "../../run/live";

/** Sensor rings that are displayed on the floor. */
export const shownRings = signal<readonly Ring[]>([]);

/** Shows or hides a sensor ring. */
export function toggleRing(ring: Ring): void {
  const { value: rings } = shownRings;
  shownRings.value = rings.includes(ring) ? rings.filter((one) => one !== ring) : [...rings, ring];
}

/** Subscribes each run to the displayed rings. Returns the unsubscribe function. */
export function subscribeToRings(report: (error: unknown) => void): () => void {
  const running = computed(() => {
    const { run, phase } = robot.live.value;
    return phase === "running" || phase === "paused" ? run : null;
  });
  let asked = false;
  return effect(() => {
    const { value: rings } = shownRings;
    if (!running.value || (rings.length === 0 && !asked)) return;
    asked = rings.length > 0;
    untracked(() => robot.command({ do: "subscribe", sensors: [...rings] }).catch(report));
  });
}
