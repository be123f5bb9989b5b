import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { robotsApi } from "../../api/robots";
import { haltKeys, held, hold, jogFault, release } from "./jog";

const asked: [number, number][] = [];
let answer: () => Promise<unknown>;

beforeEach(() => {
  vi.useFakeTimers();
  asked.length = 0;
  answer = () => Promise.resolve();
  vi.spyOn(robotsApi, "jog").mockImplementation((_link, drive, turn) => {
    asked.push([drive, turn]);
    return answer() as never;
  });
  vi.spyOn(robotsApi, "halt").mockResolvedValue({} as never);
});

afterEach(() => {
  release();
  vi.restoreAllMocks();
  vi.useRealTimers();
});

test("a held key is said ten times a second, and that it was let go at once", async () => {
  hold("dds", "left");
  await vi.advanceTimersByTimeAsync(450);
  expect(asked).toEqual(Array(5).fill([0, 1]));
  release();
  expect(asked.at(-1)).toEqual([0, 0]);
  await vi.advanceTimersByTimeAsync(500);
  expect(asked).toHaveLength(6);
});

test("a refusal ends the hold and is kept to be shown; the emergency stop asks no more", async () => {
  await haltKeys("dds");
  expect(held.value).toBeNull();
  vi.mocked(robotsApi.jog).mockRejectedValue(new Error("refused"));
  hold("dds", "back");
  await vi.advanceTimersByTimeAsync(0);
  expect(held.value).toBeNull();
  expect(jogFault.value).not.toBeNull();
});

test("a server that does not answer gets no queue of requests", async () => {
  answer = () => new Promise(() => {});
  hold("dds", "ahead");
  await vi.advanceTimersByTimeAsync(1000);
  expect(asked).toHaveLength(1);
});
