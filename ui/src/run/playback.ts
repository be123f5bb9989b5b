import { computed, signal } from "@preact/signals";
import type { RunEvent } from "../api/model";
import { categoryOf } from "../design/categories";
import type { History } from "./history";
import type { Pose } from "./reducer";

export const SPEEDS = [0.25, 0.5, 1, 2, 4, 8, 16] as const;

const TICKS_PER_MS = 30 / 1000;

/** The clock of a replay: a tick that moves while it plays. */
export class Playback {
  readonly tick = signal(0);
  readonly playing = signal(false);
  readonly speed = signal<number>(1);
  /** The whole tick, which is all that the state depends on. */
  private readonly whole = computed(() => Math.floor(this.tick.value));
  readonly view = computed(() => this.history.at(this.whole.value));
  private handle = 0;
  private last = 0;

  constructor(readonly history: History) {}

  get end(): number {
    return this.history.lastTick;
  }

  readonly pose = (): Pose => this.history.poseAt(this.tick.peek());

  toggle(): void {
    if (this.playing.value) this.pause();
    else this.play();
  }

  play(): void {
    if (this.tick.value >= this.end) this.tick.value = 0;
    this.playing.value = true;
    this.last = performance.now();
    this.handle = requestAnimationFrame(this.step);
  }

  pause(): void {
    this.playing.value = false;
    cancelAnimationFrame(this.handle);
  }

  seek(tick: number): void {
    this.tick.value = Math.min(this.end, Math.max(0, tick));
    this.last = performance.now();
  }

  dispose(): void {
    this.pause();
  }

  private readonly step = (now: number) => {
    const next = this.tick.value + Math.max(0, now - this.last) * TICKS_PER_MS * this.speed.value;
    this.last = now;
    this.tick.value = Math.min(this.end, next);
    if (this.tick.value >= this.end) this.pause();
    else this.handle = requestAnimationFrame(this.step);
  };
}

/** A stretch of time in which one block ran. */
export interface Stretch {
  from: number;
  to: number;
  action: string;
  amount: number | null;
  block: string | null;
}

const HOLDERS = new Set([
  "repeat",
  "while",
  "until",
  "for",
  "forever",
  "conditional_execution",
  "call",
]);

/** When each block that does something ran; what only holds others is left out. */
export function stretches(events: readonly RunEvent[], lastTick: number): Stretch[] {
  const found: Stretch[] = [];
  for (const event of events) {
    const open = found.at(-1);
    if (event.type === "block_started" && !HOLDERS.has(event.action)) {
      if (open && open.to > event.tick) open.to = event.tick;
      const { tick, action, amount, block } = event;
      found.push({ from: tick, to: lastTick, action, amount, block });
    }
    if (event.type === "block_ended" && open?.block === event.block && open.to === lastTick) {
      open.to = event.tick;
    }
  }
  return found;
}

/** Neighbours of one hue as one, so that a long run does not become ten thousand slivers. */
export function coarse(all: readonly Stretch[], lastTick: number, most = 300): Stretch[] {
  if (all.length <= most) return [...all];
  const gap = lastTick / most;
  const merged: Stretch[] = [];
  for (const one of all) {
    const before = merged.at(-1);
    const same = before && categoryOf(before.action) === categoryOf(one.action);
    if (before && (same || one.to - before.from < gap)) before.to = one.to;
    else merged.push({ ...one });
  }
  return merged;
}

/** The beginning of the block before or after a moment. */
export function stepFrom(all: readonly Stretch[], tick: number, way: -1 | 1, end: number): number {
  const begins = all.map((stretch) => stretch.from);
  if (way > 0) return begins.find((begin) => begin > tick + 0.5) ?? end;
  return begins.findLast((begin) => begin < tick - 0.5) ?? 0;
}
