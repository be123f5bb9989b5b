import { computed, signal } from "@preact/signals";
import { live, livePose } from "./live";
import { record } from "./live_record";
import type { RecordedStates } from "./recorded_states";
import { isLive, type Pose, type RunView } from "./reducer";

/** A tick of the last run, shown in place of the end of the run. */
interface InspectedTick {
  readonly history: RecordedStates;
  readonly tick: number;
  /** The live view at the end of that run. When `live` changes, the tick is no longer shown. */
  readonly end: RunView;
}

const chosen = signal<InspectedTick | null>(null);
const histories = new WeakMap<RunView, RecordedStates>();

/** The inspected tick of the last run; null at the end of the run and while a run is live. */
export const inspectedTick = computed(() =>
  chosen.value?.end === live.value ? chosen.value : null,
);

const past = computed(() => inspectedTick.value?.history.at(inspectedTick.value.tick) ?? null);

/** The state to show: at the inspected tick, else of the live run or at its end. */
export const shown = computed<RunView>(() => past.value ?? live.value);

/** Whether the live view is shown: beeps of an inspected tick are shown as long as the tick is. */
export const isNow = computed(() => inspectedTick.value === null);

/** The pose at which the robot is drawn at a time of the screen's clock. */
export function shownPose(now: number): Pose {
  const { history, tick } = inspectedTick.peek() ?? {};
  return history && tick !== undefined ? history.poseAt(tick) : livePose(now);
}

/** Shows a tick of the last run; for null or the last tick, shows the end of the run. */
export function inspectTick(tick: number | null): void {
  const end = live.peek();
  const isThere = end.run !== null && !isLive(end) && record.isWhole;
  if (tick === null || !isThere || tick >= record.lastTick) chosen.value = null;
  else chosen.value = { history: historyOf(end), tick: Math.max(0, Math.floor(tick)), end };
}

/** Built when the first tick of the run is inspected: a run that nobody inspects costs nothing. */
function historyOf(end: RunView): RecordedStates {
  const history = histories.get(end) ?? record.historyOf(end.run ?? "");
  histories.set(end, history);
  return history;
}
