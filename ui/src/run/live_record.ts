import { signal } from "@preact/signals";
import type { RunEvent } from "../api/model";
import { type Stretch, Timeline } from "./playback";
import { Samples } from "./samples";
import type { Telemetry } from "./telemetry";

/** Shortest time between redraws of the plots while a run is live. */
const REDRAW_MS = 200;

/** Samples of the live run, or of the last one, for the plots of the studio. */
export class LiveRecord {
  /** Changes when there are new samples to draw. */
  readonly revision = signal(0);
  samples = new Samples();
  private timeline = new Timeline();
  private timer: ReturnType<typeof setTimeout> | undefined;

  get stretches(): Stretch[] {
    return this.timeline.until(this.lastTick);
  }

  get lastTick(): number {
    return this.samples.column("tick").at(-1) ?? 0;
  }

  begin(): void {
    this.samples = new Samples();
    this.timeline = new Timeline();
    this.changed();
  }

  load(events: readonly RunEvent[], telemetry: Telemetry): void {
    this.samples = Samples.of(telemetry);
    this.timeline = new Timeline();
    for (const event of events) this.timeline.take(event);
    this.changed();
  }

  take(event: RunEvent): void {
    if (event.type === "telemetry") this.samples.push(event);
    else this.timeline.take(event);
    this.timer ??= setTimeout(() => this.changed(), REDRAW_MS);
  }

  private changed(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.revision.value++;
  }
}

export const record = new LiveRecord();
