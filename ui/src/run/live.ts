import { batch, signal } from "@preact/signals";
import { api } from "../api/client";
import { ApiError } from "../api/errors";
import type { Debugging, Run, RunEvent, RunWithVersion, StepMode } from "../api/model";
import { History } from "./history";
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

/** Where the robot is drawn at this moment of the screen's clock. */
export function livePose(now: number): Pose {
  return motion.at(now) ?? live.value.pose;
}

export function receive(event: RunEvent): void {
  const { value: view } = live;
  if (holds > 0) held.push(event);
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
  const next = reduce(live.value, event);
  if (next === live.value) return;
  if (event.type === "telemetry") motion.push(event.tick, next.pose, performance.now());
  if (event.type === "beeped") beep();
  live.value = next;
}

/** Shows the robot at the start again, with no run. */
export function clear(): void {
  if (isLive(live.value)) return;
  batch(() => {
    live.value = IDLE;
    liveRun.value = null;
    motion.reset();
  });
}

/** Starts a run; rejects with the server's words, and shows what was shown before or the run in its way. */
export function start(versionId: string, world: string, debugging: Debugging = {}): Promise<Run> {
  const before = live.value;
  const nameless = starting(null);
  stopWanted = false;
  live.value = nameless;
  motion.reset();
  return holding(async () => {
    try {
      const run = await api.startRun(versionId, world, debugging);
      turns++;
      batch(() => {
        liveRun.value = run;
        if (live.value.run !== run.id) live.value = starting(run.id);
      });
      if (stopWanted) await stop();
      return run;
    } catch (error) {
      if (live.value === nameless) live.value = before;
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
      live.value = end.phase === "idle" ? starting(runId) : end;
      motion.reset(end.pose);
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
    }
  }
}

/** The server said which run is live: catch up with it, or with the end of the one that was. */
export async function resync(runId: string | null): Promise<void> {
  const shown = live.value;
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

export const pause = () => withRun(api.pause);
export const resume = () => withRun(api.resume);

/** Stops the robot, whoever began the run and whether this page has heard of it or not. */
export async function stop(): Promise<void> {
  const { value: view } = live;
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
  const { run } = live.value;
  if (run && isLive(live.value)) await send(run);
}
