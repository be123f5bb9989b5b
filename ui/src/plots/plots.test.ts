import { describe, expect, test } from "vitest";
import type { TelemetryEvent } from "../api/model";
import { textsOf } from "../i18n";
import { type Column, rowAt, Samples } from "../run/samples";
import { csvOf } from "./csv";
import { equalRange, headings, linesOf, nearestRow, rangeOf } from "./plots";

/** Samples of a drive along x at 0.01 m a tick; `over` sets other columns in every sample. */
function driven(rows: number, over: Partial<Record<Column, number>> = {}): Samples {
  const samples = new Samples();
  for (let tick = 0; tick < rows; tick++) {
    const row = { tick, x_m: tick / 100, y_m: 0, yaw_rad: 0, v_mps: 0.3, omega_radps: 0 };
    const rest = { command_v_mps: 0.3, command_omega_radps: 0, goal_x_m: 0.5, goal_y_m: 0 };
    samples.push({ ...row, ...rest, goal_yaw_rad: 0, ...over } as unknown as TelemetryEvent);
  }
  return samples;
}

describe("samples", () => {
  test("grow past their first room and keep what they had", () => {
    const samples = driven(3000);
    expect(samples.rows).toBe(3000);
    expect(samples.column("x_m")[2500]).toBeCloseTo(25);
  });

  test("take a sample once, and none of the past", () => {
    const samples = driven(5);
    samples.push({ tick: 4, x_m: 9 } as TelemetryEvent);
    expect(samples.rows).toBe(5);
  });

  test("go on where the answer of the server ends", () => {
    const columns = new Map([
      ["tick", Float32Array.of(0, 1)],
      ["x_m", Float32Array.of(0, 0.5)],
    ]);
    const samples = Samples.of({ rows: 2, rateHz: 30, columns });
    samples.push({ tick: 2, x_m: 0.75 } as TelemetryEvent);
    expect([...samples.column("x_m")]).toEqual([0, 0.5, 0.75]);
  });

  test("are found by tick", () => {
    const ticks = Float32Array.of(0, 3, 6);
    expect([-1, 0, 2.9, 3, 100].map((tick) => rowAt(ticks, tick))).toEqual([0, 0, 0, 1, 2]);
  });
});

describe("lines", () => {
  test("tell the truth only where it is known and is something else", () => {
    const roles = (samples: Samples) => linesOf("position", samples).map((line) => line.role);
    expect(roles(driven(5))).not.toContain("true");
    expect(roles(driven(5, { true_y_m: 0, true_x_m: 9 }))).toContain("true");
    const same = driven(1, { true_x_m: 0, true_y_m: 0 });
    expect(roles(same)).not.toContain("true");
  });

  test("of headings go on past half a turn", () => {
    const samples = new Samples();
    [170, 179, -172, -160].forEach((degrees, tick) => {
      samples.push({ tick, yaw_rad: (degrees * Math.PI) / 180 } as TelemetryEvent);
    });
    expect([...headings(samples)].map(Math.round)).toEqual([170, 179, 188, 200]);
  });

  test("of desired headings stay in the turn of the robot's own", () => {
    const yaw_rad = (179 * Math.PI) / 180;
    const samples = driven(2, { yaw_rad, goal_yaw_rad: (-179 * Math.PI) / 180 });
    const desired = linesOf("heading", samples).find((line) => line.role === "desired");
    expect(desired?.values(samples)[1]).toBeCloseTo(181, 3);
  });
});

describe("axes", () => {
  test("of a path have metres of one length, whatever the plot's shape", () => {
    const square = [Float32Array.of(0, 2, 2), Float32Array.of(0, 0, 2)] as const;
    const { x, y } = equalRange([square], 600, 200);
    expect(600 / (x[1] - x[0])).toBeCloseTo(200 / (y[1] - y[0]));
    expect(y[0]).toBeLessThan(0);
    expect(y[1]).toBeGreaterThan(2);
  });

  test("do not blow up what hardly changes", () => {
    expect(rangeOf(0.99, 1.01, 0.2)).toEqual([0.9, 1.1]);
    expect(rangeOf(null, null, 2)).toEqual([-1, 1]);
  });

  test("know the nearest sample", () => {
    expect(nearestRow([0, 1, 2], [0, 0, 5], 1.2, 0.4)).toBe(1);
  });
});

describe("the table", () => {
  const lines = (language: "pt-BR" | "en") =>
    csvOf(driven(2), textsOf(language), language).split("\r\n");

  test("opens in a Brazilian spreadsheet: semicolons and decimal commas", () => {
    const [head, , second] = lines("pt-BR");
    expect(head).toMatch(/^\ufefftempo \(s\);x obtido \(m\);x desejado \(m\);/);
    expect(second).toMatch(/^0,033;0,0100;0,5000;/);
  });

  test("opens in an English one: commas and points", () => {
    expect(lines("en")[2]).toMatch(/^0\.033,0\.0100,0\.5000,/);
  });

  test("has a row for each sample and no cell of nothing", () => {
    const all = lines("pt-BR");
    expect(all).toHaveLength(4);
    expect(all.join()).not.toMatch(/NaN|-0,0000/);
    expect(all[1]?.split(";")).toHaveLength(all[0]?.split(";").length ?? 0);
  });
});
