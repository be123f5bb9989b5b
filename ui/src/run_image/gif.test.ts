import { expect, test } from "vitest";
import { GifAnimation } from "./gif";

const [WHITE, RED] = [
  [255, 255, 255],
  [200, 0, 0],
] as const;
const [WIDTH, HEIGHT] = [120, 80];

/** A white frame with a red square at `x`. */
function frame(x: number): ImageData {
  const data = new Uint8ClampedArray(WIDTH * HEIGHT * 4).fill(255);
  for (let row = 30; row < 50; row++) {
    for (let column = x; column < x + 20; column++) {
      data.set(RED, (row * WIDTH + column) * 4);
    }
  }
  return { data, width: WIDTH, height: HEIGHT, colorSpace: "srgb" } as ImageData;
}

async function bytesOf(blob: Blob): Promise<Uint8Array> {
  return new Uint8Array(await blob.arrayBuffer());
}

test("an animation begins and ends as a GIF does, and repeats for ever", async () => {
  const gif = new GifAnimation([frame(0)]);
  gif.add(frame(0), 100);
  const blob = gif.finish();
  expect(blob.type).toBe("image/gif");
  const bytes = await bytesOf(blob);
  expect(String.fromCharCode(...bytes.slice(0, 6))).toBe("GIF89a");
  expect(String.fromCharCode(...bytes)).toContain("NETSCAPE2.0");
  expect(bytes.at(-1)).toBe(0x3b);
});

test("a frame costs little where few pixels change", async () => {
  const sizeOf = async (frames: readonly ImageData[]) => {
    const gif = new GifAnimation([frame(0), frame(100)]);
    for (const one of frames) gif.add(one, 100);
    return (await bytesOf(gif.finish())).length;
  };
  const one = await sizeOf([frame(0)]);
  const still = (await sizeOf([frame(0), frame(0)])) - one;
  const moving = (await sizeOf([frame(0), frame(5)])) - one;
  expect(still).toBeLessThan(moving);
  expect(moving).toBeLessThan(one);
});

test("plain colours are stored as they are", async () => {
  const gif = new GifAnimation([frame(0)]);
  gif.add(frame(0), 100);
  const bytes = await bytesOf(gif.finish());
  const nColours = 2 << ((bytes[10] ?? 0) & 7);
  const table = Array.from({ length: nColours }, (_, at) => [
    ...bytes.slice(13 + 3 * at, 16 + 3 * at),
  ]);
  expect(table).toContainEqual([...WHITE]);
  expect(table).toContainEqual([...RED]);
});
