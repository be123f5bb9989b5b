import { describe, expect, test } from "vitest";
import type { RunEvent } from "../api/model";
import { MAX_LINES, MAX_STROKES, NOTHING, type Output, ROW_TICKS, reduceOutput } from "./output";
import { points } from "./trail";

const RUN = "run-1";
let seq = 0;
const head = (tick: number) => ({ run: RUN, v: 1, seq: seq++, tick }) as const;

const speech = (text: string, tick = 0): RunEvent => ({
  ...head(tick),
  type: "said",
  block: "b",
  text,
});
const pen = (down: boolean, color = "blue"): RunEvent => ({
  ...head(0),
  type: "pen",
  block: "p",
  down,
  color,
});
const asked = (): RunEvent => ({
  ...head(3),
  type: "asked",
  block: "a",
  question: "Quantos?",
  variable: "n",
});
const answered = (value: string | number): RunEvent => ({
  ...head(9),
  type: "answered",
  variable: "n",
  value,
});
const at = (x: number, y: number): RunEvent =>
  ({ ...head(0), type: "telemetry", x_m: x, y_m: y }) as RunEvent;

/** The output after events, with the robot at the position of the newest telemetry. */
function outputOf(...events: RunEvent[]): Output {
  let place: [number, number] = [0, 0];
  let output = NOTHING;
  for (const event of events) {
    output = reduceOutput(output, event, place);
    if (event.type === "telemetry") place = [event.x_m, event.y_m];
  }
  return output;
}

/** All strokes, including the unfinished one. */
const drawn = ({ strokes, pen }: Output) =>
  [...strokes, ...(pen ? [pen] : [])].map(({ color, trail }) => [color, [...points(trail)]]);

describe("talk", () => {
  test("is what was said, asked and answered, in order", () => {
    const { talk } = outputOf(speech("Olá"), asked(), answered(4));
    expect(talk.map(({ kind, text, number }) => [kind, text, number])).toEqual([
      ["said", "Olá", 0],
      ["asked", "Quantos?", 1],
      ["answered", 4, 2],
    ]);
  });

  test("keeps the newest lines only, and goes on counting", () => {
    const { talk } = outputOf(...Array.from({ length: MAX_LINES + 5 }, (_, n) => speech(`${n}`)));
    expect(talk).toHaveLength(MAX_LINES);
    expect(talk[0]?.text).toBe("5");
    expect(talk.at(-1)?.number).toBe(MAX_LINES + 4);
  });
});

describe("a question", () => {
  test("is open until it is answered", () => {
    expect(outputOf(asked()).question).toEqual({ block: "a", text: "Quantos?", variable: "n" });
    expect(outputOf(asked(), answered("dois")).question).toBeNull();
  });

  test("is closed when its block ends without an answer, and with the run", () => {
    const end = { ...head(9), type: "block_ended", block: "a", pointer: "/commands/0" } as const;
    expect(outputOf(asked(), end).question).toBeNull();
    const over = { ...head(9), type: "run_ended" } as RunEvent;
    expect(outputOf(asked(), over).question).toBeNull();
  });
});

describe("the pen", () => {
  test("draws the way from where it goes down to where it goes up, in its colour", () => {
    const output = outputOf(
      at(1, 0),
      pen(true, "red"),
      at(1.5, 0),
      at(2, 0),
      pen(false),
      at(3, 0),
      pen(true, "green"),
      at(3, 1),
    );
    expect(drawn(output)).toEqual([
      [
        "red",
        [
          [1, 0],
          [1.5, 0],
          [2, 0],
        ],
      ],
      [
        "green",
        [
          [3, 0],
          [3, 1],
        ],
      ],
    ]);
  });

  test("changes colour on the way without a gap", () => {
    const output = outputOf(pen(true, "red"), at(1, 0), pen(true, "blue"), at(2, 0));
    const [red, blue] = drawn(output);
    expect(red?.[1]?.at(-1)).toEqual(blue?.[1]?.at(0));
  });

  test("that is down already and told so again draws on", () => {
    expect(drawn(outputOf(pen(true), at(1, 0), pen(true), at(2, 0)))).toHaveLength(1);
  });

  test("that goes up and down on the spot makes one dot", () => {
    const dots = Array.from({ length: 50 }, () => [pen(true), pen(false)]).flat();
    expect(drawn(outputOf(at(1, 1), ...dots))).toEqual([["blue", [[1, 1]]]]);
  });

  test("forgets the oldest of very many strokes", () => {
    const dashes = Array.from({ length: MAX_STROKES + 10 }, (_, n) => [
      at(n, 0),
      pen(true),
      at(n + 0.5, 0),
      pen(false),
    ]).flat();
    expect(drawn(outputOf(...dashes))).toHaveLength(MAX_STROKES);
  });

  test("leaves the states before as they were", () => {
    const before = outputOf(pen(true), at(1, 0));
    const copy = structuredClone(before);
    reduceOutput(before, at(2, 0), [1, 0]);
    expect(before).toEqual(copy);
  });
});

test("marks are kept at their places", () => {
  const mark = { ...head(0), type: "marked", block: "m", symbol: "X", x_m: 1, y_m: -2 } as const;
  expect(outputOf(mark).marks).toEqual([{ symbol: "X", x: 1, y: -2 }]);
});

describe("beeps", () => {
  const beeped = (tick: number): RunEvent => ({ ...head(tick), type: "beeped", block: null });
  const lines = ({ talk }: Output) => talk.map(({ kind, text, tick }) => [kind, text, tick]);

  test("in a row are counted together, and share a line of the talk", () => {
    const output = outputOf(beeped(0), beeped(0), beeped(ROW_TICKS));
    expect(output.beeps).toEqual({ count: 3, inRow: 3, tick: ROW_TICKS });
    expect(lines(output)).toEqual([["beeped", 3, 0]]);
  });

  test("begin a new row after a while", () => {
    const output = outputOf(beeped(0), beeped(0), beeped(ROW_TICKS + 1));
    expect(output.beeps).toEqual({ count: 3, inRow: 1, tick: ROW_TICKS + 1 });
    expect(lines(output)).toEqual([
      ["beeped", 2, 0],
      ["beeped", 1, ROW_TICKS + 1],
    ]);
  });

  test("stand in the talk where they were heard", () => {
    const output = outputOf(beeped(0), speech("Olá", 1), beeped(2));
    expect(output.beeps.inRow).toBe(2);
    expect(lines(output).map(([kind]) => kind)).toEqual(["beeped", "said", "beeped"]);
  });
});

test("the watch tells variables and the functions that run, without the program itself", () => {
  const watch = {
    ...head(0),
    type: "watch",
    variables: { n: 3 },
    stack: [
      { function: null, block: null },
      { function: "lado", block: "c" },
    ],
    gesture: "",
  } as const;
  const output = outputOf(watch as unknown as RunEvent);
  expect(output.variables).toEqual({ n: 3 });
  expect(output.calls).toEqual([{ function: "lado", block: "c" }]);
});

test("an event that says nothing of it changes nothing", () => {
  expect(reduceOutput(NOTHING, at(1, 1), [0, 0])).toBe(NOTHING);
});
