import { describe, expect, test } from "vitest";
import { decodeTelemetry, telemetryEvent } from "./telemetry";

/** Encodes the binary response of `GET /api/runs/{id}/telemetry`, which docs/http-api.md describes. */
function encode(columns: Record<string, number[]>): ArrayBuffer {
  const names = Object.keys(columns);
  const rows = columns[names[0] ?? ""]?.length ?? 0;
  let header = JSON.stringify({ columns: names, rows, rate_hz: 30 });
  header = header.padEnd(Math.ceil(header.length / 4) * 4, " ");
  const buffer = new ArrayBuffer(4 + header.length + names.length * rows * 4);
  const view = new DataView(buffer);
  view.setUint32(0, header.length, true);
  new Uint8Array(buffer, 4).set(new TextEncoder().encode(header));
  let offset = 4 + header.length;
  for (const value of Object.values(columns).flat()) {
    view.setFloat32(offset, value, true);
    offset += 4;
  }
  return buffer;
}

describe("telemetry of a recorded run", () => {
  const telemetry = decodeTelemetry(
    encode({ tick: [1, 2, 3], x_m: [0, 0.5, 1], yaw_rad: [0, 0, 1.5], bumper: [0, 0, 1] }),
  );

  test("comes back column by column", () => {
    expect(telemetry.rows).toBe(3);
    expect(telemetry.rateHz).toBe(30);
    expect([...(telemetry.columns.get("x_m") ?? [])]).toEqual([0, 0.5, 1]);
  });

  test("is not copied", () => {
    const buffer = encode({ tick: [1] });
    expect(decodeTelemetry(buffer).columns.get("tick")?.buffer).toBe(buffer);
  });

  test("a row becomes the event that it was", () => {
    expect(telemetryEvent(telemetry, 2, "run-1")).toMatchObject({
      type: "telemetry",
      run: "run-1",
      tick: 3,
      x_m: 1,
      yaw_rad: 1.5,
      bumper: true,
    });
  });

  test("a run without telemetry has no rows", () => {
    expect(decodeTelemetry(encode({ tick: [] })).rows).toBe(0);
  });
});
