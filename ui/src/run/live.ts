import { batch, signal } from "@preact/signals";
import { api } from "../api/client";
import { ApiError } from "../api/errors";
import type {
  Debugging,
  RangesEvent,
  Ring,
  Run,
  RunEvent,
  RunWithVersion,
  StepMode,
} from "../api/model";
import { History } from "./history";
import { record } from "./live_record";
import { MotionBuffer } from "./motion_buffer";
import { IDLE, isLive, type Pose, type RunView, reduce, starting } from "./reducer";
import { beep } from "./sound";
import { decodeTelemetry, NO_TELEMETRY } from "./telemetry";

/** The run that moves the robot now, or the last one that did. */
export const live = signal<RunView>(IDLE);

/** What the server says of it: program, world; the version where it was asked for. Null until it is known. */
export const liveRun = signal<Run | RunWithVersion | null>(null);

const motion = new MotionBuffer();
/** How many requests are under way that will tell where events belong; until then events are held. */
let holds = 0;
let held: RunEvent[] = [];
/** Events that had their run followed: each may try once, or a server in trouble were asked for ever. */
const tried = new WeakSet<RunEvent>();
/** Counts what was asked of the server; only the newest answer is shown. */
let turns = 0;
/** Stop was pressed before the run had a name. */
let stopWanted = false;

/**
 * A program that computes tells of thousands of blocks a second; the page is drawn sixty times. What came since it was
 * drawn last waits here.
 */
let waiting: RunView | null = null;
let timer: ReturnType<typeof setTimeout> | undefined;
let shownAt = Number.NEGATIVE_INFINITY;
const FRAME_MS = 16;

const newest = (): RunView => waiting ?? live.value;

/** Shows a view now, in place of whatever waits. */
function show(view: RunView): void {
  clearTimeout(timer);
  waiting = null;
  shownAt = performance.now();
  live.value = view;
}

function showSoon(view: RunView): void {
  const left = shownAt + FRAME_MS - performance.now();
  if (left <= 0) show(view);
  else {
    if (!waiting) timer = setTimeout(catchUp, left);
    waiting = view;
  }
}

function catchUp(): void {
  if (waiting) show(waiting);
}

/** Where the robot is drawn at this moment of the screen's clock. */
export function livePose(now: number): Pose {
  return motion.at(now) ?? live.value.truth;
}

/** What the sensors measure, while somebody looks. */
export const ranges = signal<RangesEvent | null>(null);

export function receive(event: RunEvent): void {
  const view = newest();
  if (event.type === "ranges") {
    if (event.run === view.run) ranges.value = event;
  } else if (holds > 0) held.push(event);
  else if (event.run === view.run) apply(event);
  else if (!isLive(view) && isSignOfLife(event) && !tried.has(event)) {
    // begun in another window
    tried.add(event);
    held.push(event);
    // where this fails, the next such event tries again
    follow(event.run).catch(() => {});
  }
}

/** Telemetry comes too often to ask the server for each of it, and what has ended is not followed. */
const isSignOfLife = ({ type }: RunEvent) => type !== "telemetry" && type !== "run_ended";

function apply(event: RunEvent): void {
  const before = newest();
  const next = reduce(before, event);
  if (next === before) return;
  record.take(event);
  if (event.type === "telemetry") motion.push(event.tick, next.truth, performance.now());
  if (event.type === "beeped") beep();
  showSoon(next);
}

/** Shows the robot at the start again, with no run. */
export function clear(): void {
  if (isLive(newest())) return;
  batch(() => {
    show(IDLE);
    liveRun.value = null;
    motion.reset();
    record.begin();
  });
}

/** Starts a run; rejects with the server's words, and shows what was shown before or the run in its way. */
export function start(versionId: string, world: string, debugging: Debugging = {}): Promise<Run> {
  const before = newest();
  const nameless = starting(null);
  stopWanted = false;
  show(nameless);
  motion.reset();
  record.begin();
  return holding(async () => {
    try {
      const run = await api.startRun(versionId, world, debugging);
      turns++;
      batch(() => {
        liveRun.value = run;
        if (newest().run !== run.id) show(starting(run.id));
      });
      if (stopWanted) await stop();
      return run;
    } catch (error) {
      if (newest() === nameless) show(before);
      if (isCode(error, "run_in_progress")) await meet(stopWanted);
      throw error;
    }
  });
}

/** Fetches what a run has done so far and follows it from there. */
export function follow(runId: string): Promise<void> {
  const turn = ++turns;
  return holding(async () => {
    const [run, events, telemetry] = await Promise.all([
      api.run(runId),
      api.runEvents(runId),
      api.runTelemetry(runId).then(decodeTelemetry, () => NO_TELEMETRY),
    ]);
    if (turn !== turns) return;
    const { end } = new History(runId, events, telemetry);
    batch(() => {
      liveRun.value = run;
      show(end.phase === "idle" ? starting(runId) : end);
      motion.reset(end.truth);
      record.load(events, telemetry);
    });
  });
}

/** Holds events back while the work is done, then hands them on; what they already did changes nothing. */
async function holding<T>(work: () => Promise<T>): Promise<T> {
  holds++;
  try {
    return await work();
  } finally {
    if (--holds === 0) {
      const events = held;
      held = [];
      for (const event of events) receive(event);
      catchUp();
    }
  }
}

/** The server said which run is live: catch up with it, or with the end of the one that was. */
export async function resync(runId: string | null): Promise<void> {
  const shown = newest();
  if (runId) await follow(runId);
  else if (isLive(shown) && shown.run) await follow(shown.run);
}

export type { Debugging, StepMode };

export const step = (mode: StepMode) => withRun((run) => api.step(run, mode));
export const setBreakpoints = (blocks: readonly string[]) =>
  withRun((run) => api.setBreakpoints(run, blocks));

/** Slow motion or fast forward, from now on. */
export function setSpeed(factor: number): Promise<void> {
  motion.setSpeed(factor);
  return withRun((run) => api.setSpeed(run, factor));
}

/** Has the run tell what rings of sensors measure; none of them ends it. */
export function look(sensors: readonly Ring[]): Promise<void> {
  if (sensors.length === 0) ranges.value = null;
  return withRun((run) => api.look(run, sensors));
}

export const pause = () => withRun(api.pause);
export const resume = () => withRun(api.resume);

/** Stops the robot, whoever began the run and whether this page has heard of it or not. */
export async function stop(): Promise<void> {
  const view = newest();
  if (!isLive(view)) await meet(true);
  else if (view.run === null) stopWanted = true;
  else {
    try {
      await api.stop(view.run);
    } catch (error) {
      if (!isCode(error, "run_not_live")) throw error;
      await meet(true);
    }
  }
}

/** Asks which run is live, stops it where that is wanted, and shows it. */
async function meet(toStop: boolean): Promise<void> {
  const { run } = await api.status();
  if (run && toStop) {
    await api.stop(run).catch((error) => {
      // it ended by itself just now
      if (!isCode(error, "run_not_live")) throw error;
    });
  }
  await resync(run);
}

const isCode = (error: unknown, code: string) => error instanceof ApiError && error.code === code;

export const answerCapture = (result: string) => withRun((run) => api.answerCapture(run, result));

export const answerQuestion = (value: string) => withRun((run) => api.answerQuestion(run, value));

async function withRun(send: (run: string) => Promise<object>): Promise<void> {
  const view = newest();
  if (view.run && isLive(view)) await send(view.run);
}
