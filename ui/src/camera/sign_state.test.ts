import { describe, expect, test } from "vitest";
import { numberStateOf, signStateOf } from "./sign_state";
import { hand, numberOf, sightOf } from "./testing/camera_events";

describe("what can be said of a sign", () => {
  test("is nothing while the camera gives nothing, or sees no hand", () => {
    expect(signStateOf(null)).toEqual({ kind: "blind" });
    expect(signStateOf(sightOf())).toEqual({ kind: "no hand" });
  });

  test("is the letter once it is sure, and two of them before", () => {
    const it = { best: "F", second: "T", confidence: 0.6 };
    expect(signStateOf(sightOf(hand({ ...it, sure: false })))).toEqual({ kind: "unsure", ...it });
    expect(signStateOf(sightOf(hand(it)))).toEqual({ kind: "sure", ...it });
  });

  test("is that a hand shows no letter", () => {
    expect(signStateOf(sightOf(hand({ best: "", sure: false })))).toEqual({ kind: "no letter" });
  });

  test("is that of the hand which is sure, of two", () => {
    const two = sightOf(hand({ best: "A", sure: false }), hand({ best: "B" }));
    expect(signStateOf(two)).toMatchObject({ kind: "sure", best: "B" });
    expect(signStateOf(sightOf(hand({ best: "B" }), hand({ best: "B" })))).toMatchObject({
      best: "B",
    });
  });

  test("is that two hands show two signs, which a capture does not take", () => {
    expect(signStateOf(sightOf(hand({ best: "A" }), hand({ best: "B" })))).toEqual({
      kind: "two signs",
    });
  });

  test("names a sign that has just moved, whatever the hand shows at rest", () => {
    const sight = { ...sightOf(hand({ best: "I" })), moved: "J", moved_confidence: 0.7 };
    expect(signStateOf(sight)).toEqual({ kind: "sure", best: "J", second: "", confidence: 0.7 });
  });
});

describe("what can be said of a number", () => {
  test("is nothing until the camera counts", () => {
    expect(numberStateOf(null)).toEqual({ kind: "blind" });
    expect(numberStateOf(sightOf(hand()))).toEqual({ kind: "blind" });
  });

  test("is the count, the doubt between two, and whether there is a hand at all", () => {
    expect(numberStateOf(numberOf())).toMatchObject({ kind: "sure", best: "3" });
    const unsure = numberOf({ sure: false, confidence: 0.6 });
    expect(numberStateOf(unsure)).toMatchObject({ kind: "unsure", best: "3", second: "4" });
    const turned = numberOf({ best: "4", second: "3", sure: false });
    expect(numberStateOf(turned)).toMatchObject({ kind: "unsure", best: "3", second: "4" });
    const none = { best: "", second: "", sure: false, confidence: 0 };
    expect(numberStateOf(numberOf(none))).toEqual({ kind: "no letter" });
    expect(numberStateOf({ ...numberOf(none), hands: [] })).toEqual({ kind: "no hand" });
  });

  test("does not depend on the sign that the same hand shows", () => {
    expect(signStateOf(numberOf())).toEqual({ kind: "no letter" });
  });
});
