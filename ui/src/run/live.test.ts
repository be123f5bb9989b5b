import { waitFor } from "@testing-library/preact";
import { beforeEach, describe, expect, test, vi } from "vitest";
import type { RunEvent, TelemetryEvent } from "../api/model";

const api = {
  startRun: vi.fn(),
  command: vi.fn(),
  status: vi.fn(),
  run: vi.fn(),
  runEvents: vi.fn(),
  runTelemetry: vi.fn(),
};
vi.mock("../api/client", () => ({ api }));

/** Interval between redraws of the page. */
const FRAME_MS = 16;

let page: typeof import("./live");
/** Class of the same module instance as the page: a reloaded module has its own classes. */
let ApiError: typeof import("../api/errors").ApiError;

/** Events of the run `other` in the server's store. */
let stored: RunEvent[] = [];

const head = (run: string, seq: number) => ({ v: 1, run, seq, tick: seq }) as const;

const running = (run: string): RunEvent => ({
  ...head(run, 0),
  type: "run_state",
  state: "running",
});

const started = (run: string, seq: number, n: number): RunEvent => ({
  ...head(run, seq),
  type: "block_started",
  block: `b${n}`,
  pointer: `/commands/${n}`,
  action: "move_forward",
  amount: 1,
});

const ended = (run: string, seq: number): RunEvent => ({
  ...head(run, seq),
  type: "run_ended",
  state: "stopped",
  reason: "stopped",
  params: {},
  block: null,
  n_executed: 1,
  duration_s: 1,
  path_length_m: 0,
  closing_error_m: 0,
  pose: null,
  telemetry_sha256: "0",
});

const STOP = { do: "stop" };

const conflict = (code: string) => new ApiError(409, { code, message: code });

const settled = () => waitFor(() => expect(page.live.value.run).toBe("other"));

/** Waits until a request was made and has got a response the given number of times. */
const asked = (what: ReturnType<typeof vi.fn>, times: number) =>
  waitFor(() => expect(what.mock.settledResults.length).toBe(times));

beforeEach(async () => {
  vi.resetAllMocks();
  stored = [];
  api.run.mockImplementation(async (id: string) => ({ id, program_id: "p", version: null }));
  api.runEvents.mockImplementation(async () => stored);
  api.runTelemetry.mockRejectedValue(new Error("none yet"));
  api.status.mockResolvedValue({ run: null });
  api.command.mockResolvedValue({});
  vi.resetModules();
  ({ ApiError } = await import("../api/errors"));
  page = await import("./live");
});

describe("a run begun in another window", () => {
  test("is followed from its first event, and Stop stops it", async () => {
    page.receive(running("other"));
    await settled();
    expect(page.live.value.phase).toBe("running");
    expect(page.liveRun.value?.program_id).toBe("p");
    await page.stop();
    expect(api.command.mock.calls).toEqual([["other", STOP]]);
    expect(api.status).not.toHaveBeenCalled();
  });

  test("loses no event while it is fetched, and no event counts twice", async () => {
    stored = [running("other"), started("other", 1, 0)];
    page.receive(running("other"));
    page.receive(started("other", 1, 0));
    page.receive(started("other", 2, 1));
    await settled();
    await waitFor(() => expect(page.live.value.seq).toBe(2));
    expect(page.live.value.stack.map((entry) => entry.block)).toEqual(["b0", "b1"]);
    expect(api.run).toHaveBeenCalledTimes(1);
  });

  test("may be over before it was fetched", async () => {
    page.receive(running("other"));
    page.receive(ended("other", 1));
    await settled();
    await waitFor(() => expect(page.live.value.phase).toBe("stopped"));
  });

  test("is fetched once an event, not for ever, where the server is in trouble", async () => {
    api.run.mockRejectedValue(new Error("trouble"));
    page.receive(running("other"));
    await asked(api.run, 1);
    page.receive({ ...head("other", 1), type: "telemetry" } as TelemetryEvent);
    page.receive(started("other", 2, 0));
    await asked(api.run, 2);
    expect(page.live.value.run).toBeNull();
  });

  test("leaves alone the run that is shown", async () => {
    page.receive(running("other"));
    await settled();
    page.receive(started("older", 7, 0));
    expect(api.run.mock.calls).toEqual([["other"]]);
    expect(page.live.value.run).toBe("other");
  });
});

describe("Stop", () => {
  test("asks which run is live where the page knows of none, and shows it", async () => {
    stored = [running("other")];
    api.status.mockResolvedValue({ run: "other" });
    await page.stop();
    expect(api.command.mock.calls).toEqual([["other", STOP]]);
    expect(page.live.value.run).toBe("other");
  });

  test("does nothing where nothing runs", async () => {
    await page.stop();
    expect(api.command).not.toHaveBeenCalled();
  });

  test("reaches the run that came after the one that is shown", async () => {
    page.receive(running("other"));
    await settled();
    api.status.mockResolvedValue({ run: "next" });
    api.command.mockRejectedValueOnce(conflict("run_not_live"));
    await page.stop();
    expect(api.command.mock.calls).toEqual([
      ["other", STOP],
      ["next", STOP],
    ]);
    expect(page.live.value.run).toBe("next");
  });

  test("is no error where the run has ended just now", async () => {
    page.receive(running("other"));
    await settled();
    stored = [running("other"), ended("other", 1)];
    api.command.mockRejectedValueOnce(conflict("run_not_live"));
    await page.stop();
    expect(page.live.value.phase).toBe("stopped");
  });
});

test("a command to a run that has ended just now is no error, and its end is shown", async () => {
  page.receive(running("other"));
  await settled();
  stored = [running("other"), ended("other", 1)];
  api.command.mockRejectedValueOnce(conflict("run_not_live"));
  expect(await page.command({ do: "pause" })).toBeNull();
  expect(page.live.value.phase).toBe("stopped");
});

describe("a start", () => {
  test("refused because another run is live shows that run", async () => {
    stored = [running("other")];
    api.status.mockResolvedValue({ run: "other" });
    api.startRun.mockRejectedValue(conflict("run_in_progress"));
    await expect(page.start("v", "w")).rejects.toThrow("run_in_progress");
    expect(page.live.value).toMatchObject({ run: "other", phase: "running" });
    expect(api.command).not.toHaveBeenCalled();
  });

  test("is not covered by an earlier run that is still being fetched", async () => {
    stored = [running("other"), ended("other", 1)];
    let answer = () => {};
    api.run.mockImplementationOnce(async (id: string) => {
      await new Promise<void>((resolve) => {
        answer = resolve;
      });
      return { id, program_id: "p", version: null };
    });
    api.startRun.mockImplementation(() => new Promise(() => {}));
    const fetched = page.follow("other");
    void page.start("v", "w");
    answer();
    await fetched;
    expect(page.live.value.phase).toBe("starting");
  });

  test("refused for another reason shows what was shown before", async () => {
    const before = page.live.value;
    api.startRun.mockRejectedValue(new ApiError(503, { code: "engine_not_ready" }));
    await expect(page.start("v", "w")).rejects.toThrow();
    expect(page.live.value).toBe(before);
  });

  test("keeps the events that come before its answer, and Stop waits for its name", async () => {
    api.startRun.mockImplementation(async () => {
      page.receive(running("mine"));
      page.receive(started("mine", 1, 0));
      await page.stop();
      return { id: "mine", program_id: "p" };
    });
    await page.start("v", "w");
    expect(page.live.value).toMatchObject({ run: "mine", phase: "running", seq: 1 });
    expect(api.command.mock.calls).toEqual([["mine", STOP]]);
    expect(api.run).not.toHaveBeenCalled();
  });
});

describe("a program that computes", () => {
  test("shows its thousands of blocks no more often than the page is drawn, and all in the end", async () => {
    page.receive(running("other"));
    await settled();
    let drawn = 0;
    const stop = page.live.subscribe(() => drawn++);
    const startMs = performance.now();
    for (let seq = 1; seq <= 3000; seq++) page.receive(started("other", seq, seq));
    const frames = (performance.now() - startMs) / FRAME_MS;
    expect(drawn).toBeLessThanOrEqual(frames + 2);
    await waitFor(() => expect(page.live.value.seq).toBe(3000));
    stop();
  });
});
