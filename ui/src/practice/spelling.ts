import { effect, signal } from "@preact/signals";
import { sight } from "../camera/sight";

/** A sign is spelled when it was held for so long: longer than in a capture, for nobody waits for it here. */
export const HOLD_MS = 900;
/** A hand that was away for so long shows another sign, also when it is the same letter again. */
export const GAP_MS = 400;

/** A sign that is being held. */
export interface Held {
  readonly sign: string;
  readonly sinceMs: number;
  readonly lastDetectedMs: number;
  readonly isSpelled: boolean;
}

/** What is held after the camera saw `sign` ("" for none) at `nowMs`; it is spelled once, when it was held for long enough. */
export function hold(before: Held | null, sign: string, nowMs: number): Held | null {
  if (sign === "") return before && nowMs - before.lastDetectedMs < GAP_MS ? before : null;
  if (before?.sign !== sign || nowMs - before.lastDetectedMs >= GAP_MS) {
    return { sign, sinceMs: nowMs, lastDetectedMs: nowMs, isSpelled: false };
  }
  return { ...before, lastDetectedMs: nowMs, isSpelled: nowMs - before.sinceMs >= HOLD_MS };
}

/** How near a held sign is to being spelled, 0 to 1. */
export function heldPart(held: Held | null): number {
  return held ? Math.min(1, (held.lastDetectedMs - held.sinceMs) / HOLD_MS) : 0;
}

/** The text that the signs seen by the camera make. */
export class Spelling {
  readonly text = signal("");
  readonly held = signal<Held | null>(null);
  /** What was cleared last, for who wants it back. */
  readonly cleared = signal("");
  private moved = "";
  private readonly stop: () => void;

  constructor(clock: () => number = () => performance.now()) {
    this.stop = effect(() => {
      if (sight.value) this.update(sight.value.label, sight.value.moved, clock());
      else this.held.value = null;
    });
  }

  dispose(): void {
    this.stop();
  }

  write(text: string): void {
    this.text.value = text;
    this.cleared.value = "";
  }

  /** Takes the last letter away. */
  back(): void {
    this.write([...this.text.peek()].slice(0, -1).join(""));
  }

  clear(): void {
    const before = this.text.peek();
    this.write("");
    this.cleared.value = before;
  }

  bringBack(): void {
    this.write(this.cleared.peek() + this.text.peek());
  }

  private update(sign: string, moved: string, nowMs: number): void {
    if (moved && moved !== this.moved) this.write(this.text.peek() + moved);
    this.moved = moved;
    const before = this.held.peek();
    const now = hold(before, sign, nowMs);
    this.held.value = now;
    if (now?.isSpelled && !before?.isSpelled) this.write(this.text.peek() + now.sign);
  }
}
