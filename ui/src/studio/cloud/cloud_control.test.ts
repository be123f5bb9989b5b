import { signal } from "@preact/signals";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { cloudsApi } from "../../api/clouds";
import type { CloudProgressEvent, CloudRow } from "../../api/model";
import { live } from "../../run/live";
import { IDLE } from "../../run/reducer";
import { cloud as newest } from "../../shell/session";
import { CloudControl } from "./cloud_control";

const row = (seed: number, well = true): CloudRow => ({
  seed,
  well,
  cause: well ? null : "collision",
  path: [
    [0, 0],
    [1, 0],
  ],
});

const document = { commands: [{ action: "move_forward", distance: 1 }] };

function studioOf() {
  const content = signal<{ workspace: object; document: object }>({ workspace: {}, document });
  const setup = signal({ model: "pioneer_3dx" });
  const drive = vi.fn(() => Promise.resolve());
  const savedVersion = vi.fn(() => Promise.resolve<{ id: string; faults: [] } | null>(null));
  const studio = {
    open: { content, setup, ownWorld: { now: signal(null) } },
    worlds: { name: signal("empty_room") },
    start: { start: signal(null) },
    mine: signal(true),
    savedVersion,
    drive,
  };
  const control = new CloudControl(
    studio as unknown as ConstructorParameters<typeof CloudControl>[0],
  );
  return { control, content, savedVersion, drive };
}

const event = (id: string, more: Partial<CloudProgressEvent>): CloudProgressEvent => ({
  type: "cloud",
  cloud: id,
  n: 50,
  rows: [],
  is_over: false,
  good: [],
  text: "",
  block: null,
  ...more,
});

let stop = () => {};

beforeEach(() => {
  newest.value = null;
  live.value = IDLE;
  vi.spyOn(cloudsApi, "begin").mockResolvedValue({ id: "", n: 50 });
  vi.spyOn(cloudsApi, "stop").mockResolvedValue({});
});
afterEach(() => {
  stop();
  vi.restoreAllMocks();
});

/** Begins a cloud of a program without faults; returns its id. */
async function started({ control, savedVersion }: ReturnType<typeof studioOf>): Promise<string> {
  savedVersion.mockResolvedValueOnce({ id: "v", faults: [] });
  await control.begin();
  return control.now.peek()?.id ?? "";
}

function ended(id: string, n_good: number, block: string | null = null): void {
  newest.value = event(id, { rows: [row(2, false)] });
  newest.value = event(id, {
    is_over: true,
    good: Array.from({ length: n_good }, (_, index) => index + 1),
    text: "1 bate.",
    block,
  });
}

test("robots are added as they arrive, those of another cloud are not", async () => {
  const studio = studioOf();
  stop = studio.control.listen();
  const id = await started(studio);
  newest.value = event(id, { rows: [row(1)] });
  newest.value = event("another", { rows: [row(9)] });
  expect(studio.control.isRunning.value).toBe(true);
  ended(id, 1);
  expect(studio.control.now.value?.rows.map(({ seed }) => seed)).toEqual([1, 2]);
  expect(studio.control.isRunning.value).toBe(false);
  expect(studio.control.bundle.value?.paths.map(({ well }) => well)).toEqual([true, false]);
});

test("without a mission, one that reached its end far from the others gets a cross", async () => {
  const studio = studioOf();
  stop = studio.control.listen();
  const id = await started(studio);
  newest.value = event(id, { rows: [row(1), row(2)] });
  expect(studio.control.rows.value.map(({ well }) => well)).toEqual([true, true]);
  newest.value = event(id, { is_over: true, good: [1] });
  expect(studio.control.bundle.value?.paths.map(({ well }) => well)).toEqual([true, false]);
});

test("a stop does not overtake the request that starts the robots", async () => {
  const studio = studioOf();
  let answer = () => {};
  vi.spyOn(cloudsApi, "begin").mockReturnValue(
    new Promise((done) => {
      answer = () => done({ id: "", n: 50 });
    }),
  );
  const starting = started(studio);
  await vi.waitFor(() => expect(cloudsApi.begin).toHaveBeenCalled());
  studio.control.stop();
  await Promise.resolve();
  expect(cloudsApi.stop).not.toHaveBeenCalled();
  answer();
  const id = await starting;
  expect(cloudsApi.stop).toHaveBeenCalledWith(id);
});

test("a changed program makes them stale: faint, without advice, and none of them drives", async () => {
  const studio = studioOf();
  stop = studio.control.listen();
  ended(await started(studio), 31, "block");
  expect(studio.control.advice.value?.block).toBe("block");
  studio.content.value = { workspace: {}, document: { commands: [] } };
  expect(studio.control.bundle.value?.isFaint).toBe(true);
  expect(studio.control.advice.value).toBeNull();
  await studio.control.runOne(2);
  expect(studio.drive).not.toHaveBeenCalled();
});

test("the next ones know how many did it before", async () => {
  const studio = studioOf();
  stop = studio.control.listen();
  ended(await started(studio), 31);
  await started(studio);
  expect(studio.control.now.value?.before).toBe(31);
});

test("the case that was chosen stays, and only counts of one case are compared", async () => {
  const studio = studioOf();
  stop = studio.control.listen();
  ended(await started(studio), 31);
  studio.savedVersion.mockResolvedValue({ id: "v", faults: [] });
  await studio.control.begin(3);
  expect(studio.control.now.value?.before).toBeNull();
  ended(studio.control.now.value?.id ?? "", 20);
  await studio.control.begin();
  expect(cloudsApi.begin).toHaveBeenLastCalledWith(expect.objectContaining({ case: 3 }));
  expect(studio.control.now.value?.before).toBe(20);
});

test("they read what people gave in the last run, also after one of them was watched", async () => {
  const studio = studioOf();
  stop = studio.control.listen();
  live.value = { ...IDLE, run: "asked" };
  ended(await started(studio), 31);
  studio.drive.mockImplementationOnce(async () => {
    live.value = { ...IDLE, run: "watched" };
  });
  await studio.control.runOne(2);
  await started(studio);
  expect(cloudsApi.begin).toHaveBeenLastCalledWith(expect.objectContaining({ run_id: "asked" }));
});

test("a program with faults keeps what is on the floor", async () => {
  const studio = studioOf();
  stop = studio.control.listen();
  const id = await started(studio);
  ended(id, 31);
  await studio.control.begin();
  expect(studio.control.now.value?.id).toBe(id);
});

test("one of them drives by its seed, as the realistic robot", async () => {
  const studio = studioOf();
  stop = studio.control.listen();
  ended(await started(studio), 31);
  await studio.control.runOne(2);
  const cloud = { case: 1, run_id: null };
  const expected = { seed: 2, cloud, preset: "realistic", feedback: "odometry" };
  expect(studio.drive).toHaveBeenCalledWith(expect.objectContaining(expected));
});

test("stop ends those under way, and nothing once all have arrived", async () => {
  const studio = studioOf();
  stop = studio.control.listen();
  const id = await started(studio);
  studio.control.stop();
  await vi.waitFor(() => expect(cloudsApi.stop).toHaveBeenCalledWith(id));
  ended(id, 31);
  studio.control.stop();
  expect(cloudsApi.stop).toHaveBeenCalledTimes(1);
});
