import { GIFEncoder, nearestColorIndex, quantize } from "gifenc";

/** Colours of an animation; one more index of its palette stands for "as before". */
const MAX_COLOURS = 255;
/** Pixels from which the colours are chosen: each nth. */
const SAMPLED_EVERY = 3;
const DISPOSE_NOTHING = 1;

/** An animation as a GIF. A frame stores only the pixels that differ from the frame before. */
export class GifAnimation {
  private readonly encoder = GIFEncoder();
  private readonly colours: [number, number, number][];
  /** The index of each colour that has occurred. */
  private readonly known = new Map<number, number>();
  private last: Uint32Array | null = null;

  /**
   * @param typical - frames that have all colours of the animation, such as its first and its last.
   */
  constructor(typical: readonly ImageData[]) {
    this.colours = quantize(sampleOf(typical), MAX_COLOURS);
  }

  add(frame: ImageData, delayMs: number): void {
    const { width, height } = frame;
    const isFirst = this.last === null;
    this.encoder.writeFrame(this.indexed(frame), width, height, {
      ...(isFirst && { palette: [...this.colours, [0, 0, 0]] }),
      delay: delayMs,
      transparent: !isFirst,
      transparentIndex: this.colours.length,
      dispose: DISPOSE_NOTHING,
    });
  }

  /** Size of the frames so far, in bytes. */
  get size(): number {
    return this.encoder.bytesView().length;
  }

  finish(): Blob {
    this.encoder.finish();
    return new Blob([this.encoder.bytes()], { type: "image/gif" });
  }

  /** The palette's index of each pixel, or the index for "as before". */
  private indexed({ data }: ImageData): Uint8Array {
    const pixels = new Uint32Array(data.buffer);
    const { last } = this;
    const result = new Uint8Array(pixels.length);
    for (let at = 0; at < pixels.length; at++) {
      const pixel = pixels[at] ?? 0;
      result[at] = last?.[at] === pixel ? this.colours.length : this.indexOf(pixel);
    }
    this.last = pixels;
    return result;
  }

  private indexOf(pixel: number): number {
    let index = this.known.get(pixel);
    if (index === undefined) {
      const rgb = [pixel & 255, (pixel >> 8) & 255, (pixel >> 16) & 255];
      index = nearestColorIndex(this.colours, rgb);
      this.known.set(pixel, index);
    }
    return index;
  }
}

function sampleOf(frames: readonly ImageData[]): Uint8ClampedArray {
  const sampled: number[] = [];
  for (const { data } of frames) {
    const pixels = new Uint32Array(data.buffer);
    for (let at = 0; at < pixels.length; at += SAMPLED_EVERY) sampled.push(pixels[at] ?? 0);
  }
  return new Uint8ClampedArray(Uint32Array.from(sampled).buffer);
}
