import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import type { RunEvent } from "../../api/model";
import { Playback, timelineOf } from "../playback";
import { RecordedStates } from "../recorded_states";
import { NO_TELEMETRY } from "../telemetry";
import { CaptureShow, SHOW_MS } from "./capture_show";

const RUN = "run-1";
let seq = 0;
const result = (sign: string, tick: number): RunEvent => ({
  ...{ v: 1, run: RUN, seq: seq++, tick, type: "gesture_result", source: "capture" },
  ...{ result: sign, by: "camera", confidence: 0.9, second: "", what: "sign" },
});
const block = (sign: string): RunEvent => ({ ...result(sign, 0), source: "block" }) as RunEvent;

beforeEach(() => {
  seq = 0;
  vi.useFakeTimers();
});
afterEach(() => vi.useRealTimers());

const answersTo = (events: RunEvent[]) => timelineOf(events).captures;
const shown = ({ now }: CaptureShow) => now.value?.label ?? null;

test("answers are shown one after the other, and then nothing", () => {
  const show = new CaptureShow();
  show.start(answersTo([result("B", 0), block("X"), result("A", 0)]));
  expect(shown(show)).toBe("B");
  vi.advanceTimersByTime(SHOW_MS);
  expect(shown(show)).toBe("A");
  vi.advanceTimersByTime(SHOW_MS);
  expect(shown(show)).toBeNull();
});

describe("a replay stands still for each sign", () => {
  const replayOf = (...events: RunEvent[]) => {
    const ticks = Float32Array.of(1, 30);
    const telemetry = { ...NO_TELEMETRY, rows: 2, columns: new Map([["tick", ticks]]) };
    const isStill = events.every(({ tick }) => tick === 0);
    const history = new RecordedStates(RUN, events, isStill ? NO_TELEMETRY : telemetry);
    return new Playback(history, answersTo(events));
  };

  test("also if the robot never moved, so that it lasts long enough to see the sign", () => {
    const playback = replayOf(result("B", 0));
    expect(playback.end).toBe(0);
    playback.play();
    vi.advanceTimersByTime(SHOW_MS / 2);
    expect(shown(playback.show)).toBe("B");
    expect(playback.playing.value).toBe(true);
    vi.advanceTimersByTime(SHOW_MS);
    expect(shown(playback.show)).toBeNull();
    expect(playback.playing.value).toBe(false);
  });

  test("at its tick, and goes on from there", () => {
    const playback = replayOf(result("B", 0), result("A", 15));
    playback.play();
    vi.advanceTimersByTime(SHOW_MS / 2);
    expect([playback.tick.value, shown(playback.show)]).toEqual([0, "B"]);
    vi.advanceTimersByTime(SHOW_MS / 2 + 1000);
    expect([playback.tick.value, shown(playback.show)]).toEqual([15, "A"]);
    vi.advanceTimersByTime(SHOW_MS + 1000);
    expect([playback.tick.value, playback.playing.value]).toEqual([30, false]);
  });

  test("but not on a clock that two runs share", () => {
    const playback = replayOf(result("B", 0), result("A", 15));
    playback.stopsAtCaptures = false;
    playback.play();
    vi.advanceTimersByTime(1100);
    expect([playback.tick.value, shown(playback.show)]).toEqual([30, null]);
  });

  test("and shows a sign whose mark is pressed", () => {
    const playback = replayOf(result("B", 0), result("A", 15));
    playback.showAnswers(answersTo([result("A", 15)]));
    expect([playback.tick.value, shown(playback.show)]).toEqual([15, "A"]);
    playback.seek(20);
    expect(shown(playback.show)).toBeNull();
  });
});
