import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { choose } from "./settings";
import { isSwapDue, restartSwapTimer, startSwapTimer, swapMinutesOfClass } from "./swap_timer";

beforeEach(() => vi.useFakeTimers());
afterEach(() => {
  void choose("pinel_turns", "0");
  swapMinutesOfClass.value = null;
  vi.useRealTimers();
});

const wait = (minutes: number) => vi.advanceTimersByTime(minutes * 60_000);

test("nobody is told to swap unless a teacher wanted it", () => {
  startSwapTimer("a");
  wait(60);
  expect(isSwapDue.value).toBe(false);
});

test("it is time after the minutes chosen, and again after those", () => {
  void choose("pinel_turns", "5");
  startSwapTimer("a");
  wait(4.9);
  expect(isSwapDue.value).toBe(false);
  wait(0.2);
  expect(isSwapDue.value).toBe(true);
  restartSwapTimer();
  expect(isSwapDue.value).toBe(false);
  wait(5.1);
  expect(isSwapDue.value).toBe(true);
});

test("another group begins anew, another program of the same does not", () => {
  void choose("pinel_turns", "10");
  startSwapTimer("b");
  wait(9);
  startSwapTimer("b");
  wait(1.1);
  expect(isSwapDue.value).toBe(true);
  startSwapTimer("c");
  expect(isSwapDue.value).toBe(false);
});

test("what is set for the class counts instead of what is set for the PC, also not to be reminded", () => {
  void choose("pinel_turns", "15");
  startSwapTimer("d");
  swapMinutesOfClass.value = 5;
  wait(5.1);
  expect(isSwapDue.value).toBe(true);
  swapMinutesOfClass.value = 0;
  wait(60);
  expect(isSwapDue.value).toBe(false);
});
