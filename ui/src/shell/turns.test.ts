import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { isTurnOver, restartTurn, setTurnMinutes, startTurns } from "./turns";

beforeEach(() => vi.useFakeTimers());
afterEach(() => {
  setTurnMinutes(0);
  vi.useRealTimers();
});

const wait = (minutes: number) => vi.advanceTimersByTime(minutes * 60_000);

test("nobody is told to swap unless a teacher wanted it", () => {
  startTurns("a");
  wait(60);
  expect(isTurnOver.value).toBe(false);
});

test("it is time after the minutes chosen, and again after those", () => {
  setTurnMinutes(5);
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
  setTurnMinutes(10);
  startTurns("b");
  wait(9);
  startTurns("b");
  wait(1.1);
  expect(isTurnOver.value).toBe(true);
  startTurns("c");
  expect(isTurnOver.value).toBe(false);
});
