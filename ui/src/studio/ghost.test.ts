import { signal } from "@preact/signals";
import { afterEach, expect, test, vi } from "vitest";
import type { Robot } from "../api/model";
import { points } from "../run/trail";
import { Ghost, poseAt } from "./ghost";

const CASE = {
  given: "partida em x 2",
  seen: false,
  passed: false,
  path: [
    [2, 1, 0],
    [3, 1, 0],
    [3, 1, Math.PI / 2],
  ] as [number, number, number][],
};
const robot = signal({ name: "pioneer" } as unknown as Robot);

afterEach(() => {
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
});

test("a pose of the path is interpolated", () => {
  expect(poseAt(CASE.path, 0)).toEqual({ x: 2, y: 1, yaw: 0 });
  expect(poseAt(CASE.path, 0.25)).toEqual({ x: 2.5, y: 1, yaw: 0 });
  expect(poseAt(CASE.path, 1)).toEqual({ x: 3, y: 1, yaw: Math.PI / 2 });
});

test("the ghost drives along the whole path, stays, and goes by the second press", () => {
  const frames: FrameRequestCallback[] = [];
  vi.spyOn(window, "requestAnimationFrame").mockImplementation((frame) => frames.push(frame));
  vi.spyOn(performance, "now").mockReturnValue(1000);
  const ghost = new Ghost(robot);
  expect(ghost.companion.value).toBeNull();
  ghost.toggle(CASE);
  expect(ghost.companion.value?.pose()).toEqual({ x: 2, y: 1, yaw: 0 });
  frames.pop()?.(2500);
  expect(ghost.companion.value?.pose()).toEqual({ x: 3, y: 1, yaw: 0 });
  frames.pop()?.(9000);
  expect(frames).toEqual([]);
  expect([...points(ghost.companion.value?.view.path ?? { chunks: [], tail: [] })]).toHaveLength(3);
  ghost.toggle(CASE);
  expect(ghost.companion.value).toBeNull();
});

test("where motion is not wanted, the ghost stands at its end at once", () => {
  vi.stubGlobal("matchMedia", () => ({ matches: true }));
  const ghost = new Ghost(robot);
  ghost.toggle(CASE);
  expect(ghost.companion.value?.pose().yaw).toBeCloseTo(Math.PI / 2);
});
