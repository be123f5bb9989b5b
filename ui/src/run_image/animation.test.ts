import { expect, test } from "vitest";
import { encodeAnimation } from "./animation";
import { FRAMES_PER_S } from "./frame_plan";

const [WIDTH, HEIGHT] = [64, 48];
const LAST_TICK = 90;
const progress = { onProgress: () => {}, signal: new AbortController().signal };

/** Frames that share no pixel with another, as no run has them. */
function noise(tick: number): ImageData {
  let state = tick + 1;
  const data = new Uint8ClampedArray(WIDTH * HEIGHT * 4).map(() => {
    state = (state * 16807) % 2147483647;
    return state % 256;
  });
  return { data, width: WIDTH, height: HEIGHT, colorSpace: "srgb" } as ImageData;
}

/** Encodes the animation; also counts the frames of its last attempt. */
async function encoded(maxBytes?: number): Promise<{ blob: Blob; nFrames: number }> {
  let ticks: number[] = [];
  const draw = (tick: number) => {
    if (tick === 0) ticks = [];
    ticks.push(tick);
    return noise(tick);
  };
  const blob = await encodeAnimation(LAST_TICK, draw, progress, maxBytes);
  if (!blob) throw new Error("aborted");
  return { blob, nFrames: ticks.length };
}

test("an animation that is too large has fewer frames, the last of them too", async () => {
  const whole = await encoded();
  expect(whole.nFrames).toBe((LAST_TICK / 30) * FRAMES_PER_S + 1);
  const half = whole.blob.size / 2 + 5_000;
  const smaller = await encoded(half);
  expect(smaller.blob.size).toBeLessThanOrEqual(half);
  expect(smaller.nFrames).toBe((LAST_TICK / 30) * (FRAMES_PER_S / 2) + 1);
});

test("an animation whose frames never fit is made all the same, with the fewest frames", async () => {
  expect((await encoded(1_000)).nFrames).toBe(3);
});

test("nothing is made after the work was ended", async () => {
  const end = new AbortController();
  const draw = (tick: number) => {
    if (tick > 30) end.abort();
    return noise(tick);
  };
  const { signal } = end;
  expect(await encodeAnimation(LAST_TICK, draw, { ...progress, signal })).toBeNull();
});
