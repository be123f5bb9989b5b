import { describe, expect, test } from "vitest";
import type { RunEvent } from "../api/model";
import { Playback, stepFrom, timelineOf } from "./playback";
import { RecordedStates } from "./recorded_states";
import { activeBlockId } from "./reducer";
import type { Telemetry } from "./telemetry";

const RUN = "run-1";
const LAST = 120;

/** A recording that drives 0.01 m a tick for 60 ticks, then turns 3 degrees a tick. */
function recorded(): [RunEvent[], Telemetry] {
  const head = (seq: number, tick: number) => ({ v: 1, run: RUN, seq, tick }) as const;
  const started = (seq: number, tick: number, n: number, action: string, amount: number) =>
    ({
      ...head(seq, tick),
      type: "block_started",
      block: `b${n}`,
      pointer: `/commands/${n}`,
      action,
      amount,
    }) as const;
  const ended = (seq: number, tick: number, n: number) =>
    ({
      ...head(seq, tick),
      type: "block_ended",
      block: `b${n}`,
      pointer: `/commands/${n}`,
    }) as const;
  const events: RunEvent[] = [
    { ...head(0, 0), type: "run_state", state: "running" },
    started(1, 0, 0, "move_forward", 0.6),
    ended(2, 60, 0),
    started(3, 60, 1, "turn", 180),
    ended(4, LAST, 1),
    {
      ...head(5, LAST),
      type: "run_ended",
      state: "finished",
      reason: null,
      params: {},
      block: null,
      n_executed: 2,
      duration_s: 4,
      path_length_m: 0.6,
      closing_error_m: 0.6,
      pose: { x_m: 0.6, y_m: 0, yaw_rad: Math.PI },
      telemetry_sha256: "0",
    },
  ];
  const ticks = Array.from({ length: LAST }, (_, index) => index + 1);
  const column = (value: (tick: number) => number) => Float32Array.from(ticks, value);
  const columns = new Map([
    ["tick", column((tick) => tick)],
    ["x_m", column((tick) => Math.min(tick, 60) / 100)],
    ["yaw_rad", column((tick) => (Math.max(0, tick - 60) * 3 * Math.PI) / 180)],
    ["done", column((tick) => (tick <= 60 ? tick / 100 : (tick - 60) * 3))],
  ]);
  return [events, { rows: LAST, rateHz: 30, columns }];
}

describe("a recorded run", () => {
  const [events, telemetry] = recorded();
  const history = new RecordedStates(RUN, events, telemetry);

  test("has the state of any moment, forwards and backwards", () => {
    expect(activeBlockId(history.at(30))).toBe("b0");
    expect(activeBlockId(history.at(90))).toBe("b1");
    expect(activeBlockId(history.at(30))).toBe("b0");
    expect(history.at(30).pose.x).toBeCloseTo(0.3);
    expect(history.at(90).motion).toMatchObject({ kind: "turn", amount: 180, done: 90 });
  });

  test("ends as it ended", () => {
    expect(history.lastTick).toBe(LAST);
    expect(history.at(LAST).phase).toBe("finished");
    expect(history.at(LAST).pose.x).toBeCloseTo(0.6);
  });

  test("has poses between its samples", () => {
    expect(history.poseAt(30.5).x).toBeCloseTo(0.305);
    expect(history.poseAt(0)).toEqual({ x: 0, y: 0, yaw: 0 });
  });

  test("is a stretch of time for each block", () => {
    const found = timelineOf(events).until(LAST);
    expect(found.map(({ from, to, action }) => [from, to, action])).toEqual([
      [0, 60, "move_forward"],
      [60, LAST, "turn"],
    ]);
  });

  test("is stepped through from block to block", () => {
    const found = timelineOf(events).until(LAST);
    expect(stepFrom(found, 0, 1, LAST)).toBe(60);
    expect(stepFrom(found, 60, 1, LAST)).toBe(LAST);
    expect(stepFrom(found, LAST, -1, LAST)).toBe(60);
    expect(stepFrom(found, 60, -1, LAST)).toBe(0);
  });

  test("shows the moment that was sought and never leaves its ends", () => {
    const playback = new Playback(history);
    playback.seek(90);
    expect(activeBlockId(playback.view.value)).toBe("b1");
    playback.seek(9999);
    expect(playback.tick.value).toBe(LAST);
    playback.seek(-5);
    expect(playback.tick.value).toBe(0);
  });

  test("shows what is pointed at, and comes back unless it is pressed", () => {
    const playback = new Playback(history);
    playback.seek(20);
    playback.point(90);
    playback.point(80);
    expect(playback.tick.value).toBe(80);
    playback.point(null);
    expect(playback.tick.value).toBe(20);
    playback.point(90);
    playback.seek(90);
    playback.point(null);
    expect(playback.tick.value).toBe(90);
  });

  test("is the same whether played on or opened at a moment", () => {
    const opened = new RecordedStates(RUN, events, telemetry);
    for (let tick = 0; tick <= LAST; tick++) history.at(tick);
    expect(history.at(LAST)).toEqual(opened.at(LAST));
    expect(history.at(45)).toEqual(opened.at(45));
  });
});
