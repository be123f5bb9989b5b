import { expect, test } from "vitest";
import { FrameTimer, frameSize, LAST_LEVEL, QUALITIES, type Quality, qualityOf } from "./quality";

const [FINE, PLAIN, SMALL] = [0, 1, 2].map(qualityOf) as [Quality, Quality, Quality];

const frames = (timer: FrameTimer, n: number, ms: number) =>
  Array.from({ length: n }, () => timer.isTooSlow(ms)).filter(Boolean).length;

test("thirty slow frames make one step, thirty quick ones none", () => {
  const timer = new FrameTimer();
  expect(frames(timer, 29, 50)).toBe(0);
  expect(frames(timer, 1, 50)).toBe(1);
  expect(frames(timer, 90, 17)).toBe(0);
});

test("very slow frames make a step after eight", () => {
  expect(frames(new FrameTimer(), 8, 140)).toBe(1);
});

test("some long frames among quick ones, and a hidden window, make none", () => {
  const timer = new FrameTimer();
  const steps = [...Array(25).fill(16), ...Array(5).fill(200), 5000].map((ms) =>
    timer.isTooSlow(ms),
  );
  expect(steps.some(Boolean)).toBe(false);
});

test("each step draws no more than the one before", () => {
  const pixels = QUALITIES.map((quality) => {
    const [width, height] = frameSize(quality, [1300, 700], 2);
    return width * height;
  });
  expect(pixels).toEqual(pixels.toSorted((a, b) => b - a));
  expect(qualityOf(99)).toBe(qualityOf(LAST_LEVEL));
});

test("a frame has the pixels of the screen, then those of the page, then at most 640 by 480", () => {
  expect(frameSize(FINE, [600, 500], 1.5)).toEqual([900, 750]);
  expect(frameSize(FINE, [600, 500], 3)).toEqual([1200, 1000]);
  expect(frameSize(PLAIN, [600, 500], 2)).toEqual([600, 500]);
  expect(frameSize(SMALL, [1280, 720], 2)).toEqual([640, 360]);
  expect(frameSize(SMALL, [300, 200], 2)).toEqual([300, 200]);
});
