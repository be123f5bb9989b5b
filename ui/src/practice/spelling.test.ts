import { afterEach, beforeEach, describe, expect, test } from "vitest";
import { receive, sight } from "../camera/sight";
import { changed, hand, sightOf } from "../camera/testing/camera_events";
import { GAP_MS, HOLD_MS, heldPart, Spelling } from "./spelling";

const FRAME_MS = 100;

let nowMs = 0;
let spelling: Spelling;

beforeEach(() => {
  nowMs = 0;
  receive(changed("on"));
  spelling = new Spelling(() => nowMs);
});

afterEach(() => {
  spelling.dispose();
  receive(changed("off"));
});

/** Shows a sign to the camera for some milliseconds, ten frames a second; "" for no hand. */
function show(sign: string, lastsMs: number): void {
  for (let passed = 0; passed <= lastsMs; passed += FRAME_MS) {
    receive(sign === "" ? sightOf() : sightOf(hand({ best: sign })));
    nowMs += FRAME_MS;
  }
}

describe("what signs spell", () => {
  test("is a letter for each that was held, however long", () => {
    show("O", HOLD_MS);
    show("I", 5 * HOLD_MS);
    expect(spelling.text.value).toBe("OI");
  });

  test("is nothing of a sign on the way to another", () => {
    show("F", HOLD_MS - 2 * FRAME_MS);
    show("T", HOLD_MS);
    expect(spelling.text.value).toBe("T");
  });

  test("is the same letter twice when the hand was away between", () => {
    show("R", HOLD_MS);
    show("", GAP_MS);
    show("R", HOLD_MS);
    expect(spelling.text.value).toBe("RR");
  });

  test("is one letter when a frame or two saw nothing", () => {
    show("R", 2 * FRAME_MS);
    show("", FRAME_MS);
    show("R", HOLD_MS);
    show("", FRAME_MS);
    show("R", HOLD_MS);
    expect(spelling.text.value).toBe("R");
  });

  test("comes nearer while the sign is held, and is forgotten with the camera", () => {
    show("R", HOLD_MS / 2);
    expect(heldPart(spelling.held.value)).toBeCloseTo(0.5, 0);
    receive(changed("off"));
    expect(sight.value).toBeNull();
    expect(heldPart(spelling.held.value)).toBe(0);
  });
});

describe("a sign that moved", () => {
  test("is spelled once, at once, and again when it is made again", () => {
    for (const moved of ["", "J", "J", "", "J", "Z"]) receive({ ...sightOf(), moved });
    expect(spelling.text.value).toBe("JJZ");
  });
});

describe("the text", () => {
  test("is written with the keyboard too, and its last letter taken away", () => {
    spelling.write("JOÃO");
    spelling.back();
    expect(spelling.text.value).toBe("JOÃ");
    show("O", HOLD_MS);
    expect(spelling.text.value).toBe("JOÃO");
  });

  test("that was cleared by mistake comes back, until something new is written", () => {
    spelling.write("OI");
    spelling.clear();
    expect(spelling.text.value).toBe("");
    spelling.bringBack();
    expect(spelling.text.value).toBe("OI");
    spelling.clear();
    spelling.write("A");
    expect(spelling.cleared.value).toBe("");
  });
});
