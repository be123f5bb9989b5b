import type { RunEvent } from "../api/model";
import { between } from "./motion_buffer";
import { IDLE, type Pose, type RunView, reduce } from "./reducer";
import { type Telemetry, telemetryEvent } from "./telemetry";

/** Ticks between stored states; a seek reduces at most this many ticks of events. */
const CHECKPOINT_INTERVAL_TICKS = 30;

/** Merges the events of a run and its telemetry in the order of their ticks. */
export function* inOrder(
  run: string,
  events: readonly RunEvent[],
  telemetry: Telemetry,
): Generator<RunEvent> {
  const ticks = telemetry.columns.get("tick");
  let row = 0;
  for (const event of events) {
    const last = event.type === "run_ended" ? event.tick : event.tick - 1;
    while (row < telemetry.rows && (ticks?.[row] ?? 0) <= last) {
      yield telemetryEvent(telemetry, row++, run);
    }
    yield event;
  }
  while (row < telemetry.rows) yield telemetryEvent(telemetry, row++, run);
}

/** A stored state and the index of the event after it. */
interface Checkpoint {
  readonly next: number;
  readonly view: RunView;
}

/** All states of a recorded run, at any tick. Built with the same reducer as a live run. */
export class RecordedStates {
  private readonly ordered: RunEvent[];
  private readonly checkpoints: Checkpoint[] = [];
  /** Cache of the last result, because a replay requests increasing ticks. */
  private last: Checkpoint & { tick: number } = {
    next: 0,
    view: IDLE,
    tick: Number.POSITIVE_INFINITY,
  };
  readonly lastTick: number;
  /** The state after the last event. */
  readonly end: RunView;

  constructor(
    run: string,
    events: readonly RunEvent[],
    private readonly telemetry: Telemetry,
  ) {
    this.ordered = [...inOrder(run, events, telemetry)];
    let view: RunView = { ...IDLE, run };
    let lastCheckpointTick = Number.NEGATIVE_INFINITY;
    for (const [index, event] of this.ordered.entries()) {
      if (event.tick >= lastCheckpointTick + CHECKPOINT_INTERVAL_TICKS) {
        lastCheckpointTick = event.tick;
        this.checkpoints.push({ next: index, view });
      }
      view = reduce(view, event);
    }
    this.end = view;
    this.lastTick = view.tick;
  }

  /** The state after all events up to and including `tick`. */
  at(tick: number): RunView {
    const { last } = this;
    if (last.tick <= tick && tick - last.tick < CHECKPOINT_INTERVAL_TICKS)
      return this.from(last, tick);
    const before = (checkpoint: { next: number }) =>
      (this.ordered[checkpoint.next]?.tick ?? 0) <= tick;
    const checkpoint = this.checkpoints.findLast(before) ?? this.checkpoints[0];
    return this.from({ next: checkpoint?.next ?? 0, view: checkpoint?.view ?? this.end }, tick);
  }

  private from({ next, view: known }: Checkpoint, tick: number): RunView {
    let [index, view] = [next, known];
    for (; index < this.ordered.length; index++) {
      const event = this.ordered[index];
      if (!event || event.tick > tick) break;
      view = reduce(view, event);
    }
    this.last = { next: index, view, tick };
    return view;
  }

  /** The true pose at a fractional tick, interpolated. */
  poseAt(tick: number): Pose {
    const { columns, rows } = this.telemetry;
    const ticks = columns.get("tick");
    if (!ticks || rows === 0) return this.end.truth;
    const after = firstAfter(ticks, tick);
    if (after === 0) return { x: 0, y: 0, yaw: 0 };
    if (after >= rows) return this.rowPose(rows - 1);
    const from = ticks[after - 1] ?? 0;
    const part = (tick - from) / ((ticks[after] ?? from + 1) - from);
    return between(this.rowPose(after - 1), this.rowPose(after), part);
  }

  private rowPose(row: number): Pose {
    const value = (name: string) => {
      const known = this.telemetry.columns.get(`true_${name}`)?.[row] ?? Number.NaN;
      return Number.isNaN(known) ? (this.telemetry.columns.get(name)?.[row] ?? 0) : known;
    };
    return { x: value("x_m"), y: value("y_m"), yaw: value("yaw_rad") };
  }
}

function firstAfter(sorted: Float32Array, value: number): number {
  let low = 0;
  let high = sorted.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((sorted[middle] ?? 0) <= value) low = middle + 1;
    else high = middle;
  }
  return low;
}
