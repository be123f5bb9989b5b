import { computed, effect, type ReadonlySignal, signal, untracked } from "@preact/signals";
import type { Ring, Robot, World } from "../../api/model";
import { shown } from "../../run/inspected_tick";
import * as robot from "../../run/live";
import { chosenRobot } from "../../run/real/real_robot";
import { isLive } from "../../run/reducer";
import type { Measurements } from "../ranges_view";
import { idleRanges } from "./idle_ranges";

/** Sensor rings that are displayed on the floor. */
export const shownRings = signal<readonly Ring[]>([]);

/** Shows or hides a sensor ring. */
export function toggleRing(ring: Ring): void {
  const { value: rings } = shownRings;
  shownRings.value = rings.includes(ring) ? rings.filter((one) => one !== ring) : [...rings, ring];
}

/** What the displayed sensors measure: in a live run by its link, else in the world as it is drawn. */
export function shownRanges(
  worldNow: () => World | null,
  modelNow: () => Robot | null,
): ReadonlySignal<Measurements | null> {
  return computed(() => {
    const { value: view } = robot.live;
    // nobody knows the walls around a real robot
    if (isLive(view) || chosenRobot.value) return view.run ? robot.ranges.value : null;
    const [world, model, { boxes, truth }] = [worldNow(), modelNow(), shown.value];
    return world && model && idleRanges(model, world, boxes, truth, shownRings.value);
  });
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
