import { computed, effect, signal, untracked } from "@preact/signals";
import type { Ring } from "../api/model";
import * as robot from "./live";

/** The rings of sensors that are to be seen on the floor. */
export const looking = signal<readonly Ring[]>([]);

/** Shows what a ring measures, or no longer. */
export function toggleRing(ring: Ring): void {
  const { value: rings } = looking;
  looking.value = rings.includes(ring) ? rings.filter((one) => one !== ring) : [...rings, ring];
}

/** Asks each run for what is to be seen; the answer ends that. */
export function lookAround(report: (error: unknown) => void): () => void {
  const running = computed(() => {
    const { run, phase } = robot.live.value;
    return phase === "running" || phase === "paused" ? run : null;
  });
  let asked = false;
  return effect(() => {
    const { value: rings } = looking;
    if (!running.value || (rings.length === 0 && !asked)) return;
    asked = rings.length > 0;
    untracked(() => robot.look(rings).catch(report));
  });
}
