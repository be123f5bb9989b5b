import { signal } from "@preact/signals";
import type { RunEvent } from "../api/model";
import { type Stretch, Timeline } from "./playback";
import { RecordedStates } from "./recorded_states";
import type { CaptureAnswer } from "./reducer";
import { Samples } from "./samples";
import type { Telemetry } from "./telemetry";

/** Shortest time between redraws of the plots while a run is live. */
const REDRAW_MS = 200;

/**
 * If a run has more events, all of them are dropped. The studio still has the plots, and the
 * replay has the whole run.
 */
const MAX_EVENTS = 200_000;

/** Samples and events of the live or last run, for the studio's plots and for inspecting past ticks. */
export class LiveRecord {
  /** Changes when there are new samples to draw. */
  readonly revision = signal(0);
  samples = new Samples();
  private timeline = new Timeline();
  /** All events except telemetry; null if there were more than `MAX_EVENTS`. */
  private events: RunEvent[] | null = [];
  private timer: ReturnType<typeof setTimeout> | undefined;

  get stretches(): Stretch[] {
    return this.timeline.until(this.lastTick);
  }

  get captures(): readonly CaptureAnswer[] {
    return this.timeline.captures;
  }

  get lastTick(): number {
    return this.samples.column("tick").at(-1) ?? 0;
  }

  /** Whether `historyOf` has the state at every tick of the run. */
  get isWhole(): boolean {
    return this.events !== null && (this.lastTick > 0 || this.captures.length > 0);
  }

  /** All states of the run. */
  historyOf(run: string): RecordedStates {
    return new RecordedStates(run, this.events ?? [], this.samples.telemetry);
  }

  begin(): void {
    this.samples = new Samples();
    this.timeline = new Timeline();
    this.events = [];
    this.changed();
  }

  load(events: readonly RunEvent[], telemetry: Telemetry): void {
    this.samples = Samples.of(telemetry);
    this.timeline = new Timeline();
    this.events = [];
    for (const event of events) this.addEvent(event);
    this.changed();
  }

  add(event: RunEvent): void {
    if (event.type === "telemetry") this.samples.push(event);
    else this.addEvent(event);
    this.timer ??= setTimeout(() => this.changed(), REDRAW_MS);
  }

  private addEvent(event: RunEvent): void {
    this.timeline.add(event);
    if (this.events?.length === MAX_EVENTS) this.events = null;
    this.events?.push(event);
  }

  private changed(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.revision.value++;
  }
}

export const record = new LiveRecord();
