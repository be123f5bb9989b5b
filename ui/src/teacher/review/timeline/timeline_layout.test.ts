import { describe, expect, test } from "vitest";
import type { TimelineEntry } from "../../../api/model";
import { Axis, FOLDED_S, spansOf, stepFor } from "./axis";
import { between, GAP, minWidthFor, spread } from "./label_placement";
import { stretch } from "./stretch";
import { barHeight, layOut, ROUND } from "./timeline_layout";

const NOON = Date.UTC(2026, 10, 21, 12) / 1000;

function entry(
  kind: TimelineEntry["kind"],
  second: number,
  more: Partial<TimelineEntry> = {},
): TimelineEntry {
  const at = new Date((NOON + second) * 1000).toISOString();
  return {
    kind,
    at,
    until: null,
    computer: "PC 1",
    program_id: "p",
    program_name: "Quadrado",
    version_id: "v",
    number: 1,
    since: null,
    changes: null,
    state: null,
    reason: null,
    message: null,
    activity: null,
    other_mission: null,
    passed: null,
    unconfirmed: null,
    link: null,
    repairs: null,
    ...(kind === "run"
      ? { run_id: `run-${second}`, duration_s: 0, n_edits: null }
      : { run_id: null, duration_s: null, n_edits: 1 }),
    ...(more as object),
  };
}

function lineOf(
  entries: TimelineEntry[],
  { width = 1000, byClock = false, withDays = false } = {},
) {
  const spans = spansOf(entries);
  const axis = new Axis(spans);
  const scale = (width - 8) / Math.max(1, axis.length);
  return layOut({ entries, spans, axis, width, scale, byClock, withDays });
}

describe("time on a line", () => {
  test("is even while there are no long pauses", () => {
    const axis = new Axis([
      { from: 100, to: 110 },
      { from: 200, to: 260 },
    ]);
    expect([axis.at(100), axis.at(150), axis.at(260), axis.length]).toEqual([0, 50, 160, 160]);
    expect(axis.folds).toEqual([]);
  });

  test("folds a long pause, and goes on evenly after it", () => {
    const axis = new Axis([
      { from: 0, to: 60 },
      { from: 60 + 1200, to: 60 + 1260 },
    ]);
    expect(axis.folds).toEqual([{ at: 60, from: 60, seconds: 1200 }]);
    expect(axis.at(1260)).toBe(60 + FOLDED_S);
    expect(axis.at(660)).toBe(60 + FOLDED_S / 2);
    expect(axis.length).toBe(120 + FOLDED_S);
    expect(axis.isFolded(660)).toBe(true);
    expect(axis.isFolded(60)).toBe(false);
  });

  test("is not folded while something lasts", () => {
    const axis = new Axis([
      { from: 0, to: 1000 },
      { from: 1100, to: 1100 },
    ]);
    expect(axis.folds).toEqual([]);
  });

  test("never goes back, whatever the clock does", () => {
    const entries = [entry("edit", 0), entry("run", 600), entry("run", -3600), entry("run", -3500)];
    expect(spansOf(entries).map(({ from }) => from - NOON)).toEqual([0, 600, 600, 700]);
  });

  test("has a ruler of whole minutes", () => {
    expect([stepFor(1, 72), stepFor(0.3, 72), stepFor(0.0001, 72)]).toEqual([120, 300, 86_400]);
  });
});

describe("places", () => {
  test("are where they are wanted while there is room", () => {
    const preferred = [10, 50, 90].map((middle) => ({ middle, width: 20 }));
    expect(spread(preferred, 100)).toEqual([10, 50, 90]);
  });

  test("that are wanted twice lie side by side around it", () => {
    const preferred = [50, 50].map((middle) => ({ middle, width: 20 }));
    expect(spread(preferred, 100)).toEqual([50 - 10 - GAP / 2, 50 + 10 + GAP / 2]);
  });

  test("stay on the line and keep their order", () => {
    const preferred = [-500, 99, 99, 99, 1000].map((middle) => ({ middle, width: 18 }));
    const places = spread(preferred, 100);
    expect(minWidthFor(preferred)).toBe(98);
    places.forEach((place, index) => {
      expect(place).toBeGreaterThanOrEqual(9);
      expect(place).toBeLessThanOrEqual(91.001);
      if (index > 0) expect(place - (places[index - 1] ?? 0)).toBeGreaterThanOrEqual(20 - 1e-9);
    });
  });

  test("between knots are stretched, beyond them even", () => {
    const knots = [
      [10, 20],
      [20, 60],
    ] as const;
    expect([0, 15, 30].map((value) => between(knots, value, 2))).toEqual([0, 40, 80]);
  });
});

describe("one scale for many lines", () => {
  const sparse = [0, 100, 200].map((time) => ({ time, gap: 10 }));
  const dense = [100, 101, 102, 103].map((time) => ({ time, gap: 20 }));

  test("has the same time at the same place, and room where one line is dense", () => {
    const { positions, end } = stretch([sparse, dense], 400);
    expect(end).toBeLessThanOrEqual(400);
    expect(end).toBeGreaterThan(399);
    const [first = [], second = []] = positions;
    expect(second[0]).toBeCloseTo(first[1] ?? 0);
    second.slice(1).forEach((place, index) => {
      expect(place - (second[index] ?? 0)).toBeGreaterThanOrEqual(20 - 1e-9);
    });
  });

  test("rises with time", () => {
    const { knots } = stretch([sparse, dense], 300);
    for (const side of [0, 1] as const) {
      const values = knots.map((knot) => knot[side]);
      expect(values).toEqual([...values].sort((a, b) => a - b));
    }
  });

  test("gets longer than its room before entries overlap", () => {
    expect(stretch([dense], 30).end).toBe(80);
  });
});

describe("a line", () => {
  test("has bars of edits and round runs in their order", () => {
    const { entries } = lineOf([
      entry("edit", 0, { until: new Date((NOON + 60) * 1000).toISOString(), n_edits: 9 }),
      entry("run", 70),
      entry("run", 300),
    ]);
    expect(entries.map(({ width }) => Math.round(width))).toEqual([198, ROUND, ROUND]);
    expect(entries.map(({ x }) => x)).toEqual([...entries.map(({ x }) => x)].sort((a, b) => a - b));
  });

  test("joins a failing run and the one that made it good", () => {
    const { arcs, entries } = lineOf([
      entry("run", 0),
      entry("run", 100),
      entry("run", 200, { repairs: "run-0" }),
    ]);
    expect(arcs).toEqual([{ from: entries[0]?.x, to: entries[2]?.x }]);
  });

  test("makes entries smaller before it grows beyond its room", () => {
    const some = Array.from({ length: 45 }, (_, n) => entry("run", n * 60));
    const many = Array.from({ length: 150 }, (_, n) => entry("run", n * 20));
    expect(lineOf(some).width).toBe(1000);
    expect(lineOf(some).entries[0]?.width).toBeLessThan(ROUND);
    expect(lineOf(many).width).toBeGreaterThan(1000);
  });

  test("does not overlap, however dense", () => {
    const entries = Array.from({ length: 60 }, (_, n) => entry(n % 2 ? "run" : "edit", n * 3));
    const placed = lineOf(entries).entries;
    placed.slice(1).forEach((one, index) => {
      const before = placed[index];
      if (!before) return;
      expect(one.x - one.width / 2).toBeGreaterThan(before.x + before.width / 2);
    });
  });

  test("numbers the time, but not inside of a folded pause", () => {
    const { ticks, folds } = lineOf([entry("edit", 0), entry("run", 60), entry("run", 3660)]);
    expect(folds.map(({ fold }) => fold.seconds)).toEqual([3600]);
    const minutes = ticks.map(({ time }) => (time - NOON) / 60);
    expect(minutes.every((minute) => minute <= 1 || minute >= 61)).toBe(true);
  });

  test("counts each day from its own beginning, and no minute of a night", () => {
    const TWO_DAYS = 2 * 86_400;
    const entries = [0, 300, TWO_DAYS, TWO_DAYS + 300].map((second) => entry("run", second));
    const own = lineOf(entries, { withDays: true });
    expect(own.folds.map(({ isNight }) => isNight)).toEqual([true]);
    expect(own.ticks[0]).toMatchObject({ labelKind: "day", time: NOON });
    const minutes = own.ticks.slice(1).map(({ time, from }) => (time - from) / 60);
    expect(minutes.length).toBeGreaterThan(2);
    expect(Math.max(...minutes)).toBeLessThanOrEqual(5);
    const clock = lineOf(entries, { withDays: true, byClock: true });
    const times = clock.ticks.slice(1).map(({ time }) => time - NOON);
    expect(times.every((time) => time <= 300 || time >= TWO_DAYS)).toBe(true);
    expect(times.some((time) => time >= TWO_DAYS)).toBe(true);
    for (const { ticks, folds } of [own, clock]) {
      for (const { x } of ticks) expect(Math.abs(x - (folds[0]?.x ?? 0))).toBeGreaterThan(80);
    }
  });

  test("says days before pauses where there is no room for both", () => {
    const NIGHT = 86_400;
    const entries = [0, 360, 900, NIGHT].map((second) => entry("edit", second));
    const labelled = (width: number) =>
      lineOf(entries, { width, withDays: true }).folds.map(({ isLabelled }) => isLabelled);
    expect(labelled(1000)).toEqual([true, true, true]);
    expect(labelled(120)).toEqual([false, false, true]);
  });

  test("lasts as long as its last run does, and no number stands beyond its end", () => {
    const line = lineOf([
      entry("edit", 0),
      entry("run", 60, { duration_s: 188 }),
      entry("run", 300),
    ]);
    const [edit, long, short] = line.entries.map(({ x }) => x);
    expect(line.lengths).toHaveLength(1);
    const [length] = line.lengths;
    expect(length?.from).toBe(long);
    expect(length?.to).toBeGreaterThan(((edit ?? 0) + (short ?? 0)) / 2);
    expect(length?.to).toBeLessThan(short ?? 0);
    const only = lineOf([entry("edit", 0), entry("run", 60, { duration_s: 188 })]);
    expect(only.lengths[0]?.to).toBe(only.end);
    expect(only.ticks.every(({ x }) => x <= only.end)).toBe(true);
  });

  test("shows more edits as a higher bar, within limits", () => {
    expect(barHeight(1)).toBeLessThan(barHeight(4));
    expect(barHeight(4)).toBeLessThan(barHeight(16));
    expect(barHeight(10_000)).toBeLessThanOrEqual(30);
  });

  test("of a group that did nothing is empty", () => {
    expect(lineOf([]).entries).toEqual([]);
  });
});
