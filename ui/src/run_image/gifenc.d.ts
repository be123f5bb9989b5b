/** The part of gifenc (MIT) that is used; it has no types of its own. */
declare module "gifenc" {
  type Colour = [red: number, green: number, blue: number];

  /** `palette`: colours of the animation, with its first frame only. */
  interface FrameOptions extends Partial<Record<"palette", Colour[]>> {
    /** Time for which the frame is shown, in ms. */
    delay: number;
    /** Whether pixels of `transparentIndex` show the frame before. */
    transparent?: boolean;
    transparentIndex?: number;
    /** 1: the frame stays below the next one. */
    dispose?: number;
  }

  interface Encoder {
    writeFrame(pixels: Uint8Array, width: number, height: number, options: FrameOptions): void;
    finish(): void;
    bytes(): Uint8Array<ArrayBuffer>;
    /** The same without a copy. */
    bytesView(): Uint8Array<ArrayBuffer>;
  }

  export function GIFEncoder(): Encoder;
  export function quantize(rgba: Uint8ClampedArray, maxColours: number): Colour[];
  export function nearestColorIndex(colours: Colour[], pixel: readonly number[]): number;
}
