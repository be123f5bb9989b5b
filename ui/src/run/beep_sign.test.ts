import { signal } from "@preact/signals";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { SIGN_MS, showBeeps } from "./beep_sign";
import { IDLE, type RunView } from "./reducer";

const after = (count: number, tick: number, inRow = count, beepTick = tick): RunView => ({
  ...IDLE,
  run: "r",
  phase: "running",
  tick,
  output: { ...IDLE.output, beeps: { count, inRow, tick: beepTick } },
});

const view = signal(after(0, 0));
const still = signal(false);
let shown: number[] = [];
let stop = () => {};

beforeEach(() => {
  vi.useFakeTimers();
  view.value = after(0, 0);
  still.value = false;
  shown = [];
  stop = showBeeps(
    view,
    () => still.value,
    (n) => {
      if (n !== (shown.at(-1) ?? 0)) shown.push(n);
    },
  );
});
afterEach(() => {
  stop();
  vi.useRealTimers();
});

test("a beep is seen long enough to be noticed, in real time at any speed of the run", () => {
  view.value = after(1, 10);
  vi.advanceTimersByTime(SIGN_MS / 2);
  view.value = after(1, 2000, 1, 10);
  vi.advanceTimersByTime(SIGN_MS / 2 - 1);
  expect(shown).toEqual([1]);
  vi.advanceTimersByTime(1);
  expect(shown).toEqual([1, 0]);
});

test("beeps in a row are one sign that counts and does not flash", () => {
  for (const n of [1, 2, 3]) {
    view.value = after(n, 30 * n, 1);
    vi.advanceTimersByTime(SIGN_MS - 1);
  }
  expect(shown).toEqual([1, 2, 3]);
  vi.advanceTimersByTime(1);
  expect(shown).toEqual([1, 2, 3, 0]);
});

test("several beeps between two pictures are all counted", () => {
  view.value = after(4, 9);
  expect(shown).toEqual([4]);
});

test("a page that opens later, another run and a moment that was passed over show no beep of before", () => {
  view.value = { ...after(2, 9), run: "another" };
  view.value = { ...after(3, 500, 1, 100), run: "another" };
  expect(shown).toEqual([]);
});

test("a moment of a recording that is looked at shows its beeps for as long as it is", () => {
  still.value = true;
  view.value = after(3, 100, 2, 90);
  vi.advanceTimersByTime(10 * SIGN_MS);
  expect(shown).toEqual([2]);
  view.value = after(3, 200, 2, 90);
  expect(shown).toEqual([2, 0]);
});

test("a beep that plays is seen to its end when the replay ends, and not when it goes back", () => {
  view.value = after(1, 10);
  still.value = true;
  view.value = after(1, 300, 1, 10);
  expect(shown).toEqual([1]);
  view.value = after(0, 5);
  expect(shown).toEqual([1, 0]);
});
