import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { choose } from "./settings";
import { isTurnOver, restartTurn, startTurns, turnsOfClass } from "./turns";

beforeEach(() => vi.useFakeTimers());
afterEach(() => {
  void choose("pinel_turns", "0");
  turnsOfClass.value = null;
  vi.useRealTimers();
});

const wait = (minutes: number) => vi.advanceTimersByTime(minutes * 60_000);

test("nobody is told to swap unless a teacher wanted it", () => {
  startTurns("a");
  wait(60);
  expect(isTurnOver.value).toBe(false);
});

test("it is time after the minutes chosen, and again after those", () => {
  void choose("pinel_turns", "5");
  startTurns("a");
  wait(4.9);
  expect(isTurnOver.value).toBe(false);
  wait(0.2);
  expect(isTurnOver.value).toBe(true);
  restartTurn();
  expect(isTurnOver.value).toBe(false);
  wait(5.1);
  expect(isTurnOver.value).toBe(true);
});

test("another group begins anew, another program of the same does not", () => {
  void choose("pinel_turns", "10");
  startTurns("b");
  wait(9);
  startTurns("b");
  wait(1.1);
  expect(isTurnOver.value).toBe(true);
  startTurns("c");
  expect(isTurnOver.value).toBe(false);
});

test("what is set for the class counts instead of what is set for the PC, also not to be reminded", () => {
  void choose("pinel_turns", "15");
  startTurns("d");
  turnsOfClass.value = 5;
  wait(5.1);
  expect(isTurnOver.value).toBe(true);
  turnsOfClass.value = 0;
  wait(60);
  expect(isTurnOver.value).toBe(false);
});
