import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { VersionOfProgram, VersionSummary } from "../api/model";
import { versionsApi } from "../api/versions";
import { VersionHistory } from "./history";

/** Three edits in a burst, a run, and one more edit based on the first. */
function line(): VersionSummary[] {
  return [1, 2, 3, 4, 5].map((number) => ({
    id: `v${number}`,
    number,
    created_at: new Date(Date.UTC(2026, 9, 5, 15, 0, number)).toISOString(),
    can_run: true,
    label: "",
    parent_id: number === 5 ? "v1" : number > 1 ? `v${number - 1}` : null,
    lesson_id: null,
    computer: null,
    n_runs: number === 4 ? 1 : 0,
    n_passed: 0,
    setup: null,
    setup_only: false,
  }));
}

beforeEach(() => {
  vi.useFakeTimers();
  vi.spyOn(versionsApi, "version").mockImplementation(
    async (id) => ({ id, parent_id: null }) as VersionOfProgram,
  );
});

afterEach(() => {
  vi.useRealTimers();
  vi.restoreAllMocks();
});

test("the newest is shown first, and whoever steps quickly sees the last of it", async () => {
  const history = new VersionHistory(line(), null, () => {});
  await vi.runAllTimersAsync();
  expect(history.shown.value?.id).toBe("v5");
  for (let step = 0; step < 9; step += 1) history.step(-1);
  await vi.runAllTimersAsync();
  expect(history.shown.value?.id).toBe("v1");
  expect(versionsApi.version).toHaveBeenCalledTimes(2);
  history.dispose();
});

test("the newest is compared with the step before, any other with the newest", () => {
  const history = new VersionHistory(line(), null, () => {});
  expect(history.counterpart?.id).toBe("v4");
  history.go(1);
  expect(history.counterpart?.id).toBe("v5");
  history.dispose();
});

test("a version tells what it was made of where that is not the one before", () => {
  const history = new VersionHistory(line(), "v5", () => {});
  expect(history.madeOf.value).toBe(1);
  history.go(3);
  expect(history.madeOf.value).toBeNull();
  history.dispose();
});

test("a name is kept in the store and shown in the line", async () => {
  const label = vi.spyOn(versionsApi, "label").mockResolvedValue({});
  const history = new VersionHistory(line(), "v2", () => {});
  await history.name(" anda ");
  expect(label).toHaveBeenCalledWith("v2", " anda ");
  expect(history.chosen.value?.label).toBe("anda");
  history.dispose();
});

test("what cannot be fetched is told", async () => {
  vi.spyOn(versionsApi, "version").mockRejectedValue(new Error("gone"));
  const onError = vi.fn();
  const history = new VersionHistory(line(), null, onError);
  await vi.runAllTimersAsync();
  expect(onError).toHaveBeenCalledOnce();
  history.dispose();
});
