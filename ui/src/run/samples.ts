import type { TelemetryEvent } from "../api/model";
import { NO_TELEMETRY, type Telemetry } from "./telemetry";

/** Columns of the telemetry for plots, tables and past ticks; metres, radians, seconds, start frame. */
export const COLUMNS = [
  "tick",
  "x_m",
  "y_m",
  "yaw_rad",
  "v_mps",
  "omega_radps",
  "command_v_mps",
  "command_omega_radps",
  "goal_x_m",
  "goal_y_m",
  "goal_yaw_rad",
  "true_x_m",
  "true_y_m",
  "true_yaw_rad",
  "done",
] as const;

export type Column = (typeof COLUMNS)[number];

const FIRST_CAPACITY = 1024;

/** The samples of a run by column; they grow while it is live. Unknown values are NaN. */
export class Samples {
  rows = 0;
  private capacity = FIRST_CAPACITY;
  private columns: Float32Array[] = COLUMNS.map(() => new Float32Array(FIRST_CAPACITY));

  static of(telemetry: Telemetry): Samples {
    const samples = new Samples();
    const { rows } = telemetry;
    samples.rows = rows;
    samples.capacity = rows;
    samples.columns = COLUMNS.map((name) => {
      return telemetry.columns.get(name) ?? new Float32Array(rows).fill(Number.NaN);
    });
    return samples;
  }

  /** A view of the current samples; it does not grow. */
  column(name: Column): Float32Array {
    return (this.columns[COLUMNS.indexOf(name)] ?? new Float32Array(0)).subarray(0, this.rows);
  }

  /** The current samples in the form of a recorded run. */
  get telemetry(): Telemetry {
    const columns = new Map(COLUMNS.map((name) => [name, this.column(name)]));
    return { ...NO_TELEMETRY, rows: this.rows, columns };
  }

  push(event: TelemetryEvent): void {
    const last = this.rows > 0 ? (this.column("tick")[this.rows - 1] ?? -1) : -1;
    if (event.tick <= last) return;
    if (this.rows === this.capacity) this.grow();
    const values = event as unknown as Record<Column, number | null | undefined>;
    COLUMNS.forEach((name, index) => {
      const column = this.columns[index];
      if (column) column[this.rows] = values[name] ?? Number.NaN;
    });
    this.rows++;
  }

  private grow(): void {
    this.capacity = Math.max(FIRST_CAPACITY, 2 * this.capacity);
    this.columns = this.columns.map((column) => {
      const larger = new Float32Array(this.capacity);
      larger.set(column);
      return larger;
    });
  }
}

/** The row of the last sample at or before a tick; 0 before the first. */
export function rowAt(ticks: Float32Array, tick: number): number {
  let low = 0;
  let high = ticks.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((ticks[middle] ?? 0) <= tick) low = middle + 1;
    else high = middle;
  }
  return Math.max(0, low - 1);
}
