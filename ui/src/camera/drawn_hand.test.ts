import { beforeEach, describe, expect, test, vi } from "vitest";
import { changed, hand, sightOf } from "./testing/camera_events";

let drawn: typeof import("./drawn_hand");
let page: typeof import("./sight");

beforeEach(async () => {
  vi.resetModules();
  page = await import("./sight");
  drawn = await import("./drawn_hand");
  page.receive(changed("on"));
});

const show = (times: number, ...sides: ("left" | "right")[]) => {
  for (let n = 0; n < times; n++) {
    page.receive(sightOf(...sides.map((handedness) => hand({ handedness }))));
  }
};

describe("drawings show", () => {
  test("the hand that the camera sees, and keep it when it is away", () => {
    expect(drawn.drawnHand.value).toBe("right");
    show(4, "left");
    show(4);
    expect(drawn.drawnHand.value).toBe("left");
    show(4, "right");
    expect(drawn.drawnHand.value).toBe("right");
  });

  test("no other hand for a moment's doubt, nor for two different ones", () => {
    show(4, "right");
    show(3, "left");
    show(1, "right");
    show(3, "left");
    show(9, "left", "right");
    expect(drawn.drawnHand.value).toBe("right");
  });

  test("the hand that was chosen, until the camera sees another one than before", () => {
    show(4, "right");
    drawn.drawnHand.value = "left";
    show(9, "right");
    expect(drawn.drawnHand.value).toBe("left");
    show(4, "left");
    show(4, "right");
    expect(drawn.drawnHand.value).toBe("right");
  });
});
