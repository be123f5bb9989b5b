import { describe, expect, test } from "vitest";
import { readingOf } from "./reading";
import { hand, seen } from "./testing/seen";

describe("what can be said of a sign", () => {
  test("is nothing while the camera gives nothing, or sees no hand", () => {
    expect(readingOf(null)).toEqual({ kind: "blind" });
    expect(readingOf(seen())).toEqual({ kind: "no hand" });
  });

  test("is the letter once it is sure, and two of them before", () => {
    const it = { best: "F", second: "T", confidence: 0.6 };
    expect(readingOf(seen(hand({ ...it, sure: false })))).toEqual({ kind: "unsure", ...it });
    expect(readingOf(seen(hand(it)))).toEqual({ kind: "sure", ...it });
  });

  test("is that a hand shows no letter", () => {
    expect(readingOf(seen(hand({ best: "", sure: false })))).toEqual({ kind: "no letter" });
  });

  test("is that of the hand which is sure, of two", () => {
    const two = seen(hand({ best: "A", sure: false }), hand({ best: "B" }));
    expect(readingOf(two)).toMatchObject({ kind: "sure", best: "B" });
    expect(readingOf(seen(hand({ best: "B" }), hand({ best: "B" })))).toMatchObject({ best: "B" });
  });

  test("is that two hands show two signs, which a capture does not take", () => {
    expect(readingOf(seen(hand({ best: "A" }), hand({ best: "B" })))).toEqual({
      kind: "two signs",
    });
  });

  test("names a sign that has just moved, whatever the hand shows at rest", () => {
    const sight = { ...seen(hand({ best: "I" })), moved: "J", moved_confidence: 0.7 };
    expect(readingOf(sight)).toEqual({ kind: "sure", best: "J", second: "", confidence: 0.7 });
  });
});
