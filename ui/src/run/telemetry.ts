import type { TelemetryEvent } from "../api/model";

interface Header {
  columns: string[];
  rows: number;
  rate_hz: number;
}

/** The samples of a run by column. */
export interface Telemetry {
  readonly rows: number;
  readonly rateHz: number;
  readonly columns: ReadonlyMap<string, Float32Array>;
}

export const NO_TELEMETRY: Telemetry = { rows: 0, rateHz: 30, columns: new Map() };

/** Decodes the response of GET /api/runs/{id}/telemetry; the columns are views of the buffer. */
export function decodeTelemetry(buffer: ArrayBuffer): Telemetry {
  const length = new DataView(buffer).getUint32(0, true);
  const text = new TextDecoder().decode(new Uint8Array(buffer, 4, length));
  const header = JSON.parse(text) as Header;
  const columns = new Map<string, Float32Array>();
  header.columns.forEach((name, index) => {
    const offset = 4 + length + index * header.rows * 4;
    columns.set(name, new Float32Array(buffer, offset, header.rows));
  });
  return { rows: header.rows, rateHz: header.rate_hz, columns };
}

/** A row as a telemetry event. It has no `seq`, because telemetry is ordered by its tick only. */
export function telemetryEvent(telemetry: Telemetry, row: number, run: string): TelemetryEvent {
  const value = (name: string) => telemetry.columns.get(name)?.[row] ?? 0;
  const known = (name: string) => {
    const found = telemetry.columns.get(name)?.[row];
    return found === undefined || Number.isNaN(found) ? null : found;
  };
  return {
    v: 1,
    type: "telemetry",
    run,
    seq: -1,
    tick: value("tick"),
    x_m: value("x_m"),
    y_m: value("y_m"),
    yaw_rad: value("yaw_rad"),
    v_mps: value("v_mps"),
    omega_radps: value("omega_radps"),
    command_v_mps: value("command_v_mps"),
    command_omega_radps: value("command_omega_radps"),
    goal_x_m: value("goal_x_m"),
    goal_y_m: value("goal_y_m"),
    goal_yaw_rad: value("goal_yaw_rad"),
    true_x_m: known("true_x_m"),
    true_y_m: known("true_y_m"),
    true_yaw_rad: known("true_yaw_rad"),
    done: value("done"),
    bumper: value("bumper") > 0.5,
  };
}
