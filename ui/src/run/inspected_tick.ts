import { computed, signal } from "@preact/signals";
import type { History } from "./history";
import { live, livePose } from "./live";
import { record } from "./live_record";
import { isLive, type Pose, type RunView } from "./reducer";

/** A moment of the run that is over. */
interface InspectedTick {
  readonly history: History;
  readonly tick: number;
  /** The end of that run, as it was live: as soon as the robot does something else, the moment is over. */
  readonly end: RunView;
}

const chosen = signal<InspectedTick | null>(null);
const histories = new WeakMap<RunView, History>();

/** The moment of the last run that is shown in place of its end; null at its end, and while a run is live. */
export const inspectedTick = computed(() =>
  chosen.value?.end === live.value ? chosen.value : null,
);

const past = computed(() => inspectedTick.value?.history.at(inspectedTick.value.tick) ?? null);

/** The state to show: that of the moment, else that of the live run or of its end. */
export const shown = computed<RunView>(() => past.value ?? live.value);

/** Whether beeps are of now; those of a moment are seen as long as the moment is. */
export const isNow = computed(() => inspectedTick.value === null);

/** The pose to draw the robot at, at a time of the screen's clock. */
export function shownPose(now: number): Pose {
  const { history, tick } = inspectedTick.peek() ?? {};
  return history && tick !== undefined ? history.poseAt(tick) : livePose(now);
}

/** Shows a moment of the run that is over; at its last tick, and for null, its end. */
export function inspectTick(tick: number | null): void {
  const end = live.peek();
  const isThere = end.run !== null && !isLive(end) && record.isWhole;
  if (tick === null || !isThere || tick >= record.lastTick) chosen.value = null;
  else chosen.value = { history: historyOf(end), tick: Math.max(0, Math.floor(tick)), end };
}

/** Built at the first moment that is asked for: a run that nobody looks back at costs nothing. */
function historyOf(end: RunView): History {
  const history = histories.get(end) ?? record.historyOf(end.run ?? "");
  histories.set(end, history);
  return history;
}
