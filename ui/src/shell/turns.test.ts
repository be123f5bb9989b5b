import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { countTurns, isTurn, nextTurn, setTurnMinutes } from "./turns";

beforeEach(() => vi.useFakeTimers());
afterEach(() => {
  setTurnMinutes(0);
  vi.useRealTimers();
});

const wait = (minutes: number) => vi.advanceTimersByTime(minutes * 60_000);

test("nobody is told to swap unless a teacher wanted it", () => {
  countTurns("a");
  wait(60);
  expect(isTurn.value).toBe(false);
});

test("it is time after the minutes chosen, and again after those", () => {
  setTurnMinutes(5);
  countTurns("a");
  wait(4.9);
  expect(isTurn.value).toBe(false);
  wait(0.2);
  expect(isTurn.value).toBe(true);
  nextTurn();
  expect(isTurn.value).toBe(false);
  wait(5.1);
  expect(isTurn.value).toBe(true);
});

test("another group begins anew, another program of the same does not", () => {
  setTurnMinutes(10);
  countTurns("b");
  wait(9);
  countTurns("b");
  wait(1.1);
  expect(isTurn.value).toBe(true);
  countTurns("c");
  expect(isTurn.value).toBe(false);
});
