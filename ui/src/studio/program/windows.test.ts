import { expect, test } from "vitest";
import type { SavedVersion } from "../../api/model";
import { Windows } from "./windows";

const saved = (id: string, before: string | null): SavedVersion => ({
  id,
  before,
  created_at: "",
  faults: [],
  deleted_at: null,
});
const track = (windows: Windows, id: string, before: string | null) =>
  windows.trackSave(() => Promise.resolve(saved(id, before)));

test("who works alone hears of nothing", async () => {
  const windows = new Windows(null);
  await track(windows, "v1", null);
  windows.receive("v1");
  await track(windows, "v2", "v1");
  await track(windows, "v2", "v1");
  expect(windows.other.value).toBeNull();
});

test("what another window made last is known as soon as it is heard of", () => {
  const windows = new Windows("v1");
  windows.receive("v2");
  windows.receive("v3");
  expect([windows.other.value, windows.isStale.value]).toEqual(["v3", true]);
});

test("an answer tells of the other window where nothing was heard", async () => {
  const windows = new Windows("v1");
  await track(windows, "v3", "v2");
  expect([windows.other.value, windows.isStale.value]).toEqual(["v2", false]);
});

test("a version of one's own that is heard of before its answer is here is one's own", async () => {
  const windows = new Windows("v1");
  await windows.trackSave(async () => {
    windows.receive("v2");
    windows.receive("v3");
    expect(windows.isSending).toBe(true);
    return saved("v2", "v1");
  });
  expect([windows.other.value, windows.isStale.value]).toEqual(["v3", true]);
});

test("what is older than the opened version is in it already", () => {
  const windows = new Windows("v3");
  windows.receive("v2");
  expect(windows.other.value).toBeNull();
});

test("a save that failed tells of nothing, and holds back nothing", async () => {
  const windows = new Windows("v1");
  const failing = windows.trackSave(async () => {
    windows.receive("v2");
    throw new Error("disk full");
  });
  await expect(failing).rejects.toThrow();
  expect(windows.other.value).toBe("v2");
});
