import { waitFor } from "@testing-library/preact";
import { beforeEach, describe, expect, test, vi } from "vitest";
import type { RunEvent } from "../api/model";

vi.mock("../api/client", () => ({
  api: { startRun: async () => ({ id: "run", program_id: "p" }) },
}));

let live: typeof import("./live");
let past: typeof import("./inspected_tick");

let seq = 0;
const head = (tick: number) => ({ v: 1, run: "run", seq: seq++, tick }) as const;

function drives(block: string, from: number, to: number): void {
  const pointer = `/commands/${block}`;
  const command = { block, pointer, action: "move_forward" };
  live.receive({ ...head(from), type: "block_started", ...command, amount: 1 });
  for (let tick = from + 1; tick <= to; tick++) live.receive(sample(tick, (tick - from) / 30));
  live.receive({ ...head(to), type: "block_ended", ...command, succeeded: true } as RunEvent);
}

const sample = (tick: number, done: number): RunEvent => ({
  ...head(tick),
  type: "telemetry",
  x_m: tick / 30,
  y_m: 0,
  yaw_rad: 0,
  v_mps: 1,
  omega_radps: 0,
  command_v_mps: 1,
  command_omega_radps: 0,
  goal_x_m: tick / 30,
  goal_y_m: 0,
  goal_yaw_rad: 0,
  true_x_m: tick / 30,
  true_y_m: 0,
  true_yaw_rad: 0,
  done,
  bumper: false,
});

const state = (): RunEvent => ({ ...head(0), type: "run_state", state: "running" });

const ended = (tick: number): RunEvent => ({
  ...head(tick),
  type: "run_ended",
  state: "finished",
  reason: null,
  params: {},
  block: null,
  n_executed: 2,
  duration_s: tick / 30,
  path_length_m: 2,
  closing_error_m: 2,
  pose: null,
  telemetry_sha256: "0",
});

/** Ends the run and waits until the page shows its end. */
async function end(): Promise<void> {
  live.receive(ended(60));
  await waitFor(() => expect(live.live.value.ending).not.toBeNull());
}

beforeEach(async () => {
  vi.resetModules();
  seq = 0;
  live = await import("./live");
  past = await import("./inspected_tick");
  await live.start("version", "empty_room");
  live.receive(state());
  drives("first", 0, 30);
  drives("second", 30, 60);
});

describe("a moment of the run", () => {
  test("shows pose, block and how much of it was done", async () => {
    await end();
    past.inspectTick(45);
    const { stack, motion, phase, ending } = past.shown.value;
    expect(stack.map(({ block }) => block)).toEqual(["second"]);
    expect(motion?.done).toBeCloseTo(0.5);
    expect([phase, ending]).toEqual(["running", null]);
    expect(past.shownPose(0).x).toBeCloseTo(1.5);
    expect(past.isNow.value).toBe(false);
    past.inspectTick(10);
    expect(past.shown.value.stack[0]?.block).toBe("first");
  });

  test("is left for the end by its last tick and by null", async () => {
    await end();
    for (const tick of [60, 1000, null]) {
      past.inspectTick(10);
      expect(past.shown.value.tick).toBe(10);
      past.inspectTick(tick);
      expect(past.shown.value).toBe(live.live.value);
    }
    expect(past.shownPose(performance.now() + 1e4).x).toBeCloseTo(2);
  });

  test("is over as soon as the robot runs again, or goes back to its start", async () => {
    await end();
    past.inspectTick(10);
    await live.start("version", "empty_room");
    expect(past.inspectedTick.value).toBeNull();
    expect(past.shown.value.phase).toBe("starting");
    live.clear();
    past.inspectTick(10);
    expect(past.inspectedTick.value).toBeNull();
  });

  test("is not shown while the robot drives", () => {
    past.inspectTick(10);
    expect(past.inspectedTick.value).toBeNull();
    expect(past.shown.value).toBe(live.live.value);
  });
});
