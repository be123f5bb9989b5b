import { computed, signal } from "@preact/signals";
import type { RunEvent } from "../api/model";
import { categoryOf } from "../blocks/definitions";
import { CaptureShow } from "./captures/capture_show";
import type { RecordedStates } from "./recorded_states";
import { type CaptureAnswer, captureAnswerIn, type Pose } from "./reducer";

/** Speeds of a replay, as factors of real time. */
export const SPEEDS = [0.25, 0.5, 1, 2, 4, 8, 16] as const;

const TICKS_PER_MS = 30 / 1000;

/**
 * The clock of a replay: a tick that advances while it plays. Robot time stops during a capture, so the clock stops
 * for each answer while it is shown.
 */
export class Playback {
  readonly tick = signal(0);
  readonly playing = signal(false);
  readonly speed = signal<number>(1);
  /** The whole tick, which alone determines the state. */
  private readonly wholeTick = computed(() => Math.floor(this.tick.value));
  readonly view = computed(() => this.history.at(this.wholeTick.value));
  /** The run with its whole path. */
  readonly whole = computed(() => this.history.end);
  /** The tick at which it pauses by itself, while `playTo` plays; null otherwise. */
  readonly goal = signal<number | null>(null);
  /** The answer to a capture that is shown now. */
  readonly show = new CaptureShow();
  /** Whether the clock stops for answers to captures; two runs on one clock do not. */
  stopsAtCaptures = true;
  private handle = 0;
  private last = 0;
  /** Index of the first answer that has not been shown since the playback began. */
  private nextCapture = 0;
  /** Tick of the slider before somebody pointed at another tick; null while nobody does. */
  private pointedFrom: number | null = null;

  /** @param captures - the answers to captures for which the clock stops, in their order */
  constructor(
    readonly history: RecordedStates,
    private readonly captures: readonly CaptureAnswer[] = [],
  ) {}

  get end(): number {
    return this.history.lastTick;
  }

  readonly pose = (): Pose => this.history.poseAt(this.tick.peek());

  /** Shows the tick that somebody points at; `null` returns to the slider's tick. Ignored while playing. */
  point(tick: number | null): void {
    if (this.playing.peek()) return;
    this.pointedFrom ??= this.tick.peek();
    this.tick.value = tick === null ? this.pointedFrom : this.within(tick);
    if (tick === null) this.pointedFrom = null;
  }

  toggle(): void {
    if (this.playing.value) this.pause();
    else this.play();
  }

  play(): void {
    this.pointedFrom = null;
    this.goal.value = null;
    if (this.tick.value >= this.end) this.tick.value = 0;
    this.nextCapture = this.captures.findIndex(({ tick }) => tick >= this.tick.peek());
    this.playing.value = true;
    this.last = performance.now();
    this.handle = requestAnimationFrame(this.step);
  }

  /** Plays until a tick, and pauses there. */
  playTo(tick: number): void {
    this.play();
    this.goal.value = this.within(tick);
  }

  pause(): void {
    this.goal.value = null;
    this.playing.value = false;
    cancelAnimationFrame(this.handle);
  }

  seek(tick: number): void {
    this.pointedFrom = null;
    this.show.clear();
    this.tick.value = this.within(tick);
    this.nextCapture = this.captures.findIndex((answer) => answer.tick >= this.tick.peek());
    this.last = performance.now();
  }

  /** Pauses at answers to captures, and shows them. */
  showAnswers(answers: readonly CaptureAnswer[]): void {
    this.pause();
    this.seek(answers[0]?.tick ?? this.tick.peek());
    this.show.start(answers);
  }

  private within(tick: number): number {
    return Math.min(this.end, Math.max(0, tick));
  }

  dispose(): void {
    this.pause();
    this.show.clear();
  }

  private readonly step = (now: number) => {
    const elapsed = this.show.now.peek() ? 0 : Math.max(0, now - this.last);
    this.last = now;
    const next = this.tick.value + elapsed * TICKS_PER_MS * this.speed.value;
    const end = this.goal.value ?? this.end;
    const due = this.show.now.peek() ? [] : this.dueUntil(Math.min(end, next));
    if (due.length > 0) this.show.start(due);
    this.tick.value = Math.min(end, due[0]?.tick ?? next);
    if (this.tick.value >= end && !this.show.now.peek()) this.pause();
    else this.handle = requestAnimationFrame(this.step);
  };

  /** The next answers to captures, all of one tick, if `tick` has reached them. */
  private dueUntil(tick: number): readonly CaptureAnswer[] {
    const first = this.captures[this.nextCapture];
    if (!this.stopsAtCaptures || !first || first.tick > tick) return [];
    const due = this.captures.filter((answer) => answer.tick === first.tick);
    this.nextCapture += due.length;
    return due;
  }
}

/** Interval in which one block ran. */
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

/** Limit of the number of stretches; above it neighbours are merged. */
const MAX_STRETCHES = 6000;

/** Collects from events when each block ran, without blocks that only contain others, and what captures got. */
export class Timeline {
  readonly captures: CaptureAnswer[] = [];
  private found: Stretch[] = [];

  add(event: RunEvent): void {
    const answer = captureAnswerIn(event);
    if (answer) this.captures.push(answer);
    const open = this.found.at(-1);
    if (event.type === "block_started" && !HOLDERS.has(event.action)) {
      if (open && open.to > event.tick) open.to = event.tick;
      const { tick, action, amount, block } = event;
      if (this.found.length >= MAX_STRETCHES) this.found = coarse(this.found, tick);
      this.found.push({ from: tick, to: Number.POSITIVE_INFINITY, action, amount, block });
    }
    const isOpen = open?.to === Number.POSITIVE_INFINITY;
    if (event.type === "block_ended" && open?.block === event.block && isOpen) open.to = event.tick;
  }

  /** All stretches; an unfinished one lasts until `lastTick`. */
  until(lastTick: number): Stretch[] {
    return this.found.map((one) => ({ ...one, to: Math.min(one.to, lastTick) }));
  }
}

/** The timeline of a recorded run. */
export function timelineOf(events: readonly RunEvent[]): Timeline {
  const timeline = new Timeline();
  for (const event of events) timeline.add(event);
  return timeline;
}

/** Merges neighbours of one category, so that a long run does not become thousands of narrow stretches. */
export function coarse(all: readonly Stretch[], lastTick: number, maxStretches = 300): Stretch[] {
  if (all.length <= maxStretches) return [...all];
  const gap = lastTick / maxStretches;
  const merged: Stretch[] = [];
  for (const one of all) {
    const before = merged.at(-1);
    const same = before && categoryOf(before.action) === categoryOf(one.action);
    if (before && (same || one.to - before.from < gap)) before.to = one.to;
    else merged.push({ ...one });
  }
  return merged;
}

/** The blocks of all runs on one clock, ordered by their start. */
export function inOrder(tracks: readonly (readonly Stretch[])[]): readonly Stretch[] {
  const [only, ...others] = tracks;
  return only && others.length === 0 ? only : tracks.flat().sort((a, b) => a.from - b.from);
}

/** Start of the next or previous block. */
export function stepFrom(
  all: readonly Stretch[],
  tick: number,
  direction: -1 | 1,
  end: number,
): number {
  const begins = all.map((stretch) => stretch.from);
  if (direction > 0) return begins.find((begin) => begin > tick + 0.5) ?? end;
  return begins.findLast((begin) => begin < tick - 0.5) ?? 0;
}
