import { signal } from "@preact/signals";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { DialogueLine } from "./output";
import { IDLE, type Phase, type RunView } from "./reducer";
import { AFTER_RUN_MS, MIN_TEXT_MS, showText, TEXT_TICKS } from "./text_sign";

type Line = readonly [tick: number, text: string | number, kind?: DialogueLine["kind"]];

const at = (tick: number, lines: readonly Line[], phase: Phase = "running"): RunView => ({
  ...IDLE,
  run: "r",
  phase,
  tick,
  output: {
    ...IDLE.output,
    talk: lines.map(([tick, text, kind = "said"], number) => ({
      kind,
      text,
      number,
      tick,
      block: null,
    })),
  },
});
const HELLO: Line = [10, "Oi"];

const view = signal(at(0, []));
const still = signal(false);
let shown: unknown[] = [];
let stop = () => {};
const begin = (first: RunView) => {
  stop();
  view.value = first;
  shown = [];
  stop = showText(
    view,
    () => still.value,
    (text) => {
      if (text !== (shown.at(-1) ?? null)) shown.push(text);
    },
  );
};

beforeEach(() => {
  vi.useFakeTimers();
  still.value = false;
  begin(at(0, []));
});
afterEach(() => {
  stop();
  stop = () => {};
  vi.useRealTimers();
});

test("a text stays for four seconds of the robot, or until the next one", () => {
  view.value = at(10, [HELLO]);
  vi.advanceTimersByTime(60_000); // the robot waits for somebody
  expect(shown).toEqual(["Oi"]);
  view.value = at(40, [HELLO, [40, 3.5]]);
  vi.advanceTimersByTime(MIN_TEXT_MS);
  view.value = at(40 + TEXT_TICKS, [HELLO, [40, 3.5]]);
  expect(shown).toEqual(["Oi", 3.5, null]);
});

test("a robot that hurries shows a text long enough to be noticed", () => {
  view.value = at(10, [HELLO]);
  view.value = at(900, [HELLO]);
  vi.advanceTimersByTime(MIN_TEXT_MS - 1);
  expect(shown).toEqual(["Oi"]);
  vi.advanceTimersByTime(1);
  expect(shown).toEqual(["Oi", null]);
});

test("questions, answers and beeps after it leave a text where it is", () => {
  view.value = at(10, [HELLO, [10, "Quantos?", "asked"], [11, 3, "answered"], [12, 1, "beeped"]]);
  expect(shown).toEqual(["Oi"]);
});

test("a beep before a text does not hide it", () => {
  view.value = at(10, [[10, 1, "beeped"]]);
  view.value = at(10, [[10, 1, "beeped"], HELLO]);
  expect(shown).toEqual(["Oi"]);
});

test("the last text of a run leaves the floor some seconds after the run", () => {
  view.value = at(20, [HELLO]);
  view.value = at(20, [HELLO], "finished");
  vi.advanceTimersByTime(AFTER_RUN_MS - 1);
  expect(shown).toEqual(["Oi"]);
  vi.advanceTimersByTime(1);
  expect(shown).toEqual(["Oi", null]);
});

test("a page that opens after a run shows no text of it, until somebody looks at its tick", () => {
  begin(at(20, [HELLO], "finished"));
  expect(shown).toEqual([]);
  still.value = true;
  view.value = at(15, [HELLO]);
  expect(shown).toEqual(["Oi"]);
  vi.advanceTimersByTime(60_000);
  view.value = at(9, []);
  expect(shown).toEqual(["Oi", null]);
});

test("a replay shows each text again after it went back", () => {
  view.value = at(20, [HELLO], "finished");
  still.value = true;
  vi.advanceTimersByTime(2 * AFTER_RUN_MS);
  still.value = false;
  view.value = at(0, []);
  view.value = at(12, [HELLO]);
  expect(shown.at(-1)).toBe("Oi");
});
