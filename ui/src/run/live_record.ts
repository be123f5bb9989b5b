import { signal } from "@preact/signals";
import type { RunEvent } from "../api/model";
import { History } from "./history";
import { type Stretch, Timeline } from "./playback";
import { Samples } from "./samples";
import type { Telemetry } from "./telemetry";

/** Shortest time between redraws of the plots while a run is live. */
const REDRAW_MS = 200;

/** More events than this are not kept: of such a long run the studio has the plots, and the replay has all of it. */
const MAX_EVENTS = 200_000;

/** Samples and events of the live run, or of the last one, for the plots and the past moments of the studio. */
export class LiveRecord {
  /** Changes when there are new samples to draw. */
  readonly revision = signal(0);
  samples = new Samples();
  private timeline = new Timeline();
  /** All events except telemetry; null where there were too many. */
  private events: RunEvent[] | null = [];
  private timer: ReturnType<typeof setTimeout> | undefined;

  get stretches(): Stretch[] {
    return this.timeline.until(this.lastTick);
  }

  get lastTick(): number {
    return this.samples.column("tick").at(-1) ?? 0;
  }

  /** Whether `historyOf` can tell every moment of the run. */
  get isWhole(): boolean {
    return this.events !== null && this.lastTick > 0;
  }

  /** All states of the run. */
  historyOf(run: string): History {
    return new History(run, this.events ?? [], this.samples.telemetry);
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
