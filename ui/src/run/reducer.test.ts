import { describe, expect, test } from "vitest";
import type { RunEvent } from "../api/model";
import { activeBlockId, IDLE, isLive, type RunView, reduce, starting } from "./reducer";
import { points } from "./trail";

const RUN = "run-1";
let seq = 0;

const head = (tick: number, run = RUN) => ({ v: 1, run, seq: seq++, tick }) as const;

const started = (tick: number, pointer: string, action: string, amount: number | null = null) =>
  ({
    ...head(tick),
    type: "block_started",
    block: `b${pointer}`,
    pointer,
    action,
    amount,
  }) as const;

const ended = (tick: number, pointer: string) =>
  ({ ...head(tick), type: "block_ended", block: `b${pointer}`, pointer }) as const;

const telemetry = (tick: number, x: number, y: number, done = 0, run = RUN): RunEvent => ({
  ...head(tick, run),
  type: "telemetry",
  x_m: x,
  y_m: y,
  yaw_rad: 0,
  v_mps: 0,
  omega_radps: 0,
  command_v_mps: 0,
  command_omega_radps: 0,
  goal_x_m: x + 0.1,
  goal_y_m: y,
  goal_yaw_rad: 0,
  done,
  bumper: false,
});

const runEnded = (tick: number, state: "finished" | "stopped" | "failed"): RunEvent => ({
  ...head(tick),
  type: "run_ended",
  state,
  reason: state === "failed" ? "blocked" : null,
  params: { done: 1, amount: 9 },
  block: null,
  n_executed: 1,
  duration_s: tick / 30,
  path_length_m: 1,
  closing_error_m: 1,
  pose: { x_m: 1, y_m: 0, yaw_rad: 0 },
  telemetry_sha256: "0",
  estimated_closing_error_m: 0.5,
});

const state = (tick: number, name: "running" | "paused"): RunEvent => ({
  ...head(tick),
  type: "run_state",
  state: name,
});

const viewAfter = (...events: RunEvent[]): RunView => events.reduce(reduce, starting(RUN));

describe("a run", () => {
  test("goes from starting to running, paused, running and finished", () => {
    const phases = [
      state(0, "running"),
      state(5, "paused"),
      state(5, "running"),
      runEnded(9, "finished"),
    ];
    let view = starting(RUN);
    const observed = phases.map((event) => {
      view = reduce(view, event);
      return view.phase;
    });
    expect(observed).toEqual(["running", "paused", "running", "finished"]);
    expect(isLive(view)).toBe(false);
  });

  test("ignores events of another run", () => {
    const view = starting(RUN);
    expect(reduce(view, telemetry(1, 1, 1, 0, "another"))).toBe(view);
    expect(reduce(IDLE, state(0, "running"))).toBe(IDLE);
  });

  test("applies an event that comes twice once", () => {
    const blockStart = started(0, "/commands/0", "move_forward", 1);
    const view = viewAfter(blockStart);
    expect(reduce(view, blockStart)).toBe(view);
  });

  test("leaves the state before it as it was", () => {
    const before = viewAfter(state(0, "running"), telemetry(1, 0, 0));
    const copy = structuredClone(before);
    reduce(before, telemetry(2, 1, 0));
    reduce(before, started(2, "/commands/0", "turn", 90));
    expect(before).toEqual(copy);
  });

  test("keeps why and where it failed", () => {
    const view = viewAfter(state(0, "running"), runEnded(30, "failed"));
    expect(view.phase).toBe("failed");
    expect(view.ending).toMatchObject({ reason: "blocked", params: { done: 1, amount: 9 } });
  });
});

describe("blocks", () => {
  test("the innermost running block is lit, and its parent again when it ends", () => {
    const view = viewAfter(
      started(0, "/commands/0", "repeat"),
      started(0, "/commands/0/commands/0", "move_forward", 1),
    );
    expect(activeBlockId(view)).toBe("b/commands/0/commands/0");
    expect(activeBlockId(reduce(view, ended(50, "/commands/0/commands/0")))).toBe("b/commands/0");
  });

  test("a block without an id leaves the block around it lit", () => {
    const bare = { ...started(0, "/commands/0/commands/0", "stop"), block: null };
    expect(activeBlockId(viewAfter(started(0, "/commands/0", "repeat"), bare))).toBe(
      "b/commands/0",
    );
  });

  test("the end of a block ends what is still open inside it", () => {
    const view = viewAfter(
      started(0, "/commands/0", "repeat"),
      started(0, "/commands/0/commands/0", "wait", 1),
      ended(30, "/commands/0"),
    );
    expect(view.stack).toEqual([]);
  });

  test("rounds of a loop are counted by its first command", () => {
    const round = (tick: number) => [
      started(tick, "/commands/0/commands/0", "move_forward", 1),
      ended(tick + 1, "/commands/0/commands/0"),
      started(tick + 1, "/commands/0/commands/1", "turn", 90),
      ended(tick + 2, "/commands/0/commands/1"),
    ];
    const view = viewAfter(
      started(0, "/commands/0", "repeat"),
      ...round(0),
      ...round(2),
      ...round(4),
    );
    expect(view.stack[0]?.round).toBe(3);
  });

  test("rounds that take no time are not counted, for the robot tells of one a tick", () => {
    const spin = (tick: number) => started(tick, "/commands/0/commands/0", "set_variable");
    const view = viewAfter(started(0, "/commands/0", "forever"), spin(0), spin(1), spin(2));
    expect(view.stack[0]?.round).toBeNaN();
  });

  test("of a function that calls itself the innermost call is in its next round", () => {
    const again = (tick: number) => started(tick, "/functions/0/commands/0", "repeat");
    const inner = () => started(40, "/functions/0/commands/0/commands/0", "wait", 1);
    const view = viewAfter(again(0), again(20), inner());
    expect(view.stack.map((entry) => entry.round)).toEqual([0, 1, 0]);
  });

  test("where the run is held before a block, that block is lit until it goes on", () => {
    const paused = (tick: number, cause: string, block: string) =>
      ({ ...state(tick, "paused"), cause, block }) as RunEvent;
    const before = viewAfter(state(0, "running"), started(1, "/commands/0", "repeat"));
    const held = reduce(before, paused(3, "breakpoint", "b2"));
    expect(activeBlockId(held)).toBe("b2");
    expect(activeBlockId(reduce(held, state(4, "running")))).toBe(activeBlockId(before));
    expect(reduce(before, paused(5, "person", "b1")).next).toBeNull();
  });

  test("nothing is lit after the end", () => {
    const view = viewAfter(started(0, "/commands/0", "wait", 1), runEnded(3, "stopped"));
    expect(activeBlockId(view)).toBeNull();
    expect(view.motion).toBeNull();
  });
});

describe("telemetry", () => {
  test("moves pose, path, set-point and the part of the motion that is done", () => {
    const view = viewAfter(
      started(0, "/commands/0", "move_forward", 1),
      telemetry(1, 0, 0, 0),
      telemetry(2, 0.5, 0, 0.5),
    );
    expect(view.pose).toEqual({ x: 0.5, y: 0, yaw: 0 });
    expect(view.setpoint.x).toBeCloseTo(0.6);
    expect([...points(view.path)]).toEqual([
      [0, 0],
      [0.5, 0],
    ]);
    expect(view.motion).toMatchObject({ kind: "move_forward", amount: 1, done: 0.5 });
  });

  test("of the tick at which a block begins does not count for its motion", () => {
    const turned = telemetry(9, 0, 0, 90);
    const atStart = reduce(viewAfter(started(9, "/commands/1", "move_forward", 1)), turned);
    expect(atStart.motion?.done).toBe(0);
    expect(reduce(atStart, telemetry(10, 0.1, 0, 0.1)).motion?.done).toBe(0.1);
  });

  test("that comes late does not move the robot back", () => {
    const view = viewAfter(telemetry(9, 1, 0));
    expect(reduce(view, telemetry(3, 0, 0))).toBe(view);
  });

  test("a long path keeps its points in order", () => {
    const view = viewAfter(
      ...Array.from({ length: 500 }, (_, tick) => telemetry(tick, tick / 10, 0)),
    );
    const xs = [...points(view.path)].map(([x]) => x);
    expect(xs).toHaveLength(500);
    expect(xs).toEqual(xs.toSorted((a, b) => a - b));
  });

  test("standing still adds nothing to the path", () => {
    const view = viewAfter(telemetry(1, 0, 0), telemetry(2, 0.001, 0), telemetry(3, 0.002, 0));
    expect([...points(view.path)]).toHaveLength(1);
  });
});

describe("a capture", () => {
  const captureStart = (): RunEvent => ({
    ...head(30),
    type: "capture_started",
    block: "c",
    timeout_s: 10,
  });
  const result = (): RunEvent => ({
    ...head(60),
    type: "gesture_result",
    result: "B",
    source: "capture",
  });

  test("asks until there is a result", () => {
    const asked = viewAfter(started(30, "/commands/0", "classify_gestures"), captureStart());
    expect(asked.capture).toEqual({ block: "c", timeoutS: 10, leftS: 10, what: "sign" });
    const answered = reduce(asked, result());
    expect(answered.capture).toBeNull();
    expect(answered.gesture).toBe("B");
  });

  test("keeps who answered it and how sure the camera was; a block that sets the result does not", () => {
    const answer = {
      what: "sign",
      label: "B",
      by: "camera",
      confidence: 0.97,
      tick: 60,
      nextLine: 0,
    };
    const asked = viewAfter(captureStart());
    const view = reduce(asked, { ...result(), by: "camera", confidence: 0.97 } as RunEvent);
    expect(view.captured).toEqual(answer);
    const set = { ...head(70), type: "gesture_result", result: "A", source: "block" } as RunEvent;
    expect(reduce(view, set).captured).toEqual(answer);
  });

  test("of a number keeps the number apart from the sign; without one it is -1", () => {
    const asked = viewAfter(result(), { ...captureStart(), what: "number" } as RunEvent);
    expect(asked.capture?.what).toBe("number");
    expect(asked.number).toBeNull();
    const shown = (digits: string): RunEvent =>
      ({ ...result(), what: "number", result: digits, by: "person" }) as RunEvent;
    const answered = reduce(asked, shown("3"));
    expect(answered).toMatchObject({ capture: null, gesture: "B", number: 3 });
    expect(answered.captured).toMatchObject({ what: "number", label: "3", by: "person" });
    expect(reduce(asked, shown("")).number).toBe(-1);
  });

  test("counts down in the seconds that the run tells, which stand while it is paused", () => {
    const countdown = (left_s: number): RunEvent => ({
      ...head(30),
      type: "countdown",
      left_s,
    });
    expect(viewAfter(captureStart(), countdown(7.4)).capture?.leftS).toBe(7.4);
    expect(viewAfter(captureStart(), result(), countdown(7.2)).capture).toBeNull();
  });

  test("ends with the run", () => {
    expect(viewAfter(captureStart(), runEnded(40, "stopped")).capture).toBeNull();
  });
});

describe("the truth", () => {
  const known = (tick: number, x: number, true_x_m: number | null): RunEvent =>
    ({ ...telemetry(tick, x, 0), true_x_m, true_y_m: 0, true_yaw_rad: 0 }) as RunEvent;

  test("is what the path is drawn from; what the robot believes is beside it", () => {
    const view = viewAfter(known(1, 0, 0), known(2, 1, 0.9));
    expect([view.pose.x, view.truth.x]).toEqual([1, 0.9]);
    expect([...points(view.path)].at(-1)).toEqual([0.9, 0]);
  });

  test("is what the robot says where nobody knows better", () => {
    const view = viewAfter(known(1, 1, null));
    expect(view.truth).toBe(view.pose);
  });

  test("stays where it was at the end, which tells only what the robot believes", () => {
    const ending = runEnded(3, "finished") as Extract<RunEvent, { type: "run_ended" }>;
    const end = { ...ending, pose: { x_m: 1.01, y_m: 0, yaw_rad: 0 } };
    expect(viewAfter(known(2, 1, 0.9), end).truth.x).toBe(0.9);
    expect(viewAfter(known(2, 1, 1), end).truth.x).toBe(1.01);
  });
});

describe("how far from its start a run ended", () => {
  const ending = runEnded(3, "finished") as Extract<RunEvent, { type: "run_ended" }>;
  const { estimated_closing_error_m: _none, ...before } = { ...ending, closing_error_m: 0.2 };
  const driven = (true_x_m: number | null) =>
    ({ ...telemetry(2, 0, 0), true_x_m, true_y_m: 0, true_yaw_rad: 0 }) as RunEvent;

  test("is where it truly was, and beside it what the robot estimates", () => {
    const { closingErrorM, estimatedClosingErrorM } = viewAfter(ending).ending ?? {};
    expect([closingErrorM, estimatedClosingErrorM]).toEqual([1, 0.5]);
  });

  test("is known to nobody on a real robot, which has its estimate", () => {
    const real = { ...ending, closing_error_m: null };
    const { closingErrorM, estimatedClosingErrorM } = viewAfter(driven(null), real).ending ?? {};
    expect([closingErrorM, estimatedClosingErrorM]).toEqual([null, 0.5]);
  });

  test("was recorded as the estimate by earlier releases, whose samples know the truth", () => {
    const { closingErrorM, estimatedClosingErrorM } = viewAfter(driven(0.9), before).ending ?? {};
    expect([closingErrorM, estimatedClosingErrorM]).toEqual([0.9, 0.2]);
  });

  test("is an estimate where the samples know no more", () => {
    const { closingErrorM, estimatedClosingErrorM } = viewAfter(driven(null), before).ending ?? {};
    expect([closingErrorM, estimatedClosingErrorM]).toEqual([null, 0.2]);
  });

  test("is unknown of a run that nobody saw end", () => {
    const cutOff = { ...before, closing_error_m: null };
    const { closingErrorM, estimatedClosingErrorM } = viewAfter(driven(0.9), cutOff).ending ?? {};
    expect([closingErrorM, estimatedClosingErrorM]).toEqual([null, null]);
  });
});

test("things that were pushed are where they were told last", () => {
  const boxesEvent = (tick: number, boxes: Record<string, [number, number, number]>): RunEvent => ({
    ...head(tick),
    type: "things",
    boxes,
  });
  const view = viewAfter(
    boxesEvent(1, { 0: [1, 0, 0], 2: [0, 0, 0] }),
    boxesEvent(2, { 0: [2, 0, 0] }),
  );
  expect(view.boxes).toEqual({ 0: [2, 0, 0], 2: [0, 0, 0] });
});

describe("whether the robot was told to move", () => {
  const driven = { ...telemetry(3, 0, 0), command_omega_radps: 0.5 } as RunEvent;
  test.each([
    ["a turn", [started(1, "/commands/0", "turn", 90)], true],
    ["wheels that turn without a motion", [driven], true],
    ["waiting", [started(1, "/commands/0", "wait", 2), telemetry(2, 0, 0)], false],
    ["zero metres", [started(1, "/commands/0", "move_forward", 0), telemetry(2, 0, 0)], false],
  ])("%s", (_what, events, moved) => {
    expect(viewAfter(...(events as RunEvent[])).moved).toBe(moved);
  });
});

test("the desired path is known from where the robot leaves it, not while it follows", () => {
  const at = (tick: number, y: number): RunEvent => ({
    ...(telemetry(tick, tick / 10, y) as Extract<RunEvent, { type: "telemetry" }>),
    goal_y_m: 0,
  });
  const following = [1, 2, 3].map((tick) => at(tick, 0.001 * tick)).reduce(reduce, starting(RUN));
  expect([...points(following.idealPath)]).toEqual([]);
  const left = [at(4, 0.05), at(5, 0.01)].reduce(reduce, following);
  expect([...points(left.idealPath)]).toEqual([
    [0.5, 0],
    [0.6, 0],
  ]);
});

test("a robot that stays behind on the desired path has not left it", () => {
  const behind: RunEvent = {
    ...(telemetry(1, 1, 0) as Extract<RunEvent, { type: "telemetry" }>),
    goal_x_m: 1.2,
  };
  expect([...points(reduce(starting(RUN), behind).idealPath)]).toEqual([]);
});
