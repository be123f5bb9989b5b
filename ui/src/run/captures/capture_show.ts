import { signal } from "@preact/signals";
import type { CaptureAnswer } from "../reducer";

/** How long an answer to a capture is shown. */
export const SHOW_MS = 1500;

/** Shows answers to captures one after the other, each for `SHOW_MS`. */
export class CaptureShow {
  /** The answer that is shown; null between shows. */
  readonly now = signal<CaptureAnswer | null>(null);
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** Shows these answers; what was shown before ends. */
  start([first, ...others]: readonly CaptureAnswer[]): void {
    clearTimeout(this.timer);
    this.now.value = first ?? null;
    if (first) this.timer = setTimeout(() => this.start(others), SHOW_MS);
  }

  clear(): void {
    this.start([]);
  }
}
