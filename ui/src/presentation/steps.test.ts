import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { Playback, type Stretch } from "../run/playback";
import type { RecordedStates } from "../run/recorded_states";
import { Steps } from "./steps";

const block = (from: number, to: number): Stretch => ({
  from,
  to,
  action: "move_forward",
  amount: 1,
  block: String(from),
});
const SHORT = [block(0, 30), block(30, 60)];
const LONG = [block(0, 45), block(45, 90)];

/** A clock of a record of 90 ticks, whose states nobody reads. */
const clock = () => new Playback({ lastTick: 90 } as RecordedStates);

let frames: FrameRequestCallback[] = [];
/** Shows the picture of a time. */
function draw(now: number): void {
  const due = frames;
  frames = [];
  for (const frame of due) frame(now);
}

beforeEach(() => {
  frames = [];
  vi.spyOn(performance, "now").mockReturnValue(0);
  vi.stubGlobal("requestAnimationFrame", (frame: FrameRequestCallback) => frames.push(frame));
  vi.stubGlobal("cancelAnimationFrame", () => {
    frames = [];
  });
});
afterEach(() => {
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
});

test("a step lets the robot drive and pauses where the next block begins", () => {
  const playback = clock();
  const steps = new Steps(playback, [SHORT], () => false);
  steps.next();
  draw(500);
  expect(playback.tick.value).toBe(15);
  expect(playback.playing.value).toBe(true);
  draw(1500);
  expect(playback.tick.value).toBe(30);
  expect(playback.playing.value).toBe(false);
  expect(frames).toEqual([]);
});

test("a second press during a step is there at once, and begins no further step", () => {
  const playback = clock();
  const steps = new Steps(playback, [SHORT], () => false);
  steps.next();
  draw(200);
  steps.next();
  expect(playback.tick.value).toBe(30);
  expect(playback.playing.value).toBe(false);
  expect(frames).toEqual([]);
});

test("with reduced motion each step is there at once", () => {
  const playback = clock();
  const steps = new Steps(playback, [SHORT], () => true);
  const ticks = [0, 1, 2, 3].map(() => {
    steps.next();
    return playback.tick.value;
  });
  expect(ticks).toEqual([30, 90, 90, 90]);
});

test("a step back returns to where the current block began, then to the one before", () => {
  const playback = clock();
  const steps = new Steps(playback, [SHORT], () => true);
  playback.seek(40);
  steps.previous();
  expect(playback.tick.value).toBe(30);
  steps.previous();
  expect(playback.tick.value).toBe(0);
});

test("two runs step together, at each block of either", () => {
  const playback = clock();
  const steps = new Steps(playback, [SHORT, LONG], () => true);
  const ticks = [0, 1, 2].map(() => {
    steps.next();
    return playback.tick.value;
  });
  expect(ticks).toEqual([30, 45, 90]);
  steps.previous();
  expect(playback.tick.value).toBe(45);
});

test("playing on after a step does not stop at the next block", () => {
  const playback = clock();
  const steps = new Steps(playback, [SHORT], () => false);
  steps.next();
  playback.toggle();
  playback.toggle();
  draw(1500);
  expect(playback.tick.value).toBe(45);
  expect(playback.playing.value).toBe(true);
});
