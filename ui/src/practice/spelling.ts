import { effect, signal } from "@preact/signals";
import { sight } from "../camera/sight";

/**
 * Hold time until a sign is spelled, in milliseconds. It is longer than in a capture, because no
 * program waits here.
 */
export const HOLD_MS = 900;
/** After a gap of this length, in milliseconds, the same letter counts as a new sign. */
export const GAP_MS = 400;

/** The sign that is currently held. */
export interface Held {
  readonly sign: string;
  readonly sinceMs: number;
  readonly lastDetectedMs: number;
  readonly isSpelled: boolean;
}

/**
 * Updates the held sign with the detection of `sign` ("" for none) at `nowMs`. Spells each held
 * sign once, after HOLD_MS.
 */
export function hold(before: Held | null, sign: string, nowMs: number): Held | null {
  if (sign === "") return before && nowMs - before.lastDetectedMs < GAP_MS ? before : null;
  if (before?.sign !== sign || nowMs - before.lastDetectedMs >= GAP_MS) {
    return { sign, sinceMs: nowMs, lastDetectedMs: nowMs, isSpelled: false };
  }
  return { ...before, lastDetectedMs: nowMs, isSpelled: nowMs - before.sinceMs >= HOLD_MS };
}

/** Fraction of the hold time that has passed, 0 to 1. */
export function heldPart(held: Held | null): number {
  return held ? Math.min(1, (held.lastDetectedMs - held.sinceMs) / HOLD_MS) : 0;
}

/** Collects the signs that the camera detects into a text. */
export class Spelling {
  readonly text = signal("");
  readonly held = signal<Held | null>(null);
  /** The text that was cleared last, so that the user can restore it. */
  readonly cleared = signal("");
  /** Receives the signs instead of the text, while a game is played. */
  onSign: ((sign: string) => void) | null = null;
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

  /** Deletes the last letter. */
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
    if (moved && moved !== this.moved) this.spell(moved);
    this.moved = moved;
    const before = this.held.peek();
    const now = hold(before, sign, nowMs);
    this.held.value = now;
    if (now?.isSpelled && !before?.isSpelled) this.spell(now.sign);
  }

  private spell(sign: string): void {
    if (this.onSign) this.onSign(sign);
    else this.write(this.text.peek() + sign);
  }
}
