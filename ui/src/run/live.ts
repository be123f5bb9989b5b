import { batch, signal } from "@preact/signals";
import { api } from "../api/client";
import type { Run, RunEvent } from "../api/model";
import { History } from "./history";
import { MotionBuffer } from "./motion_buffer";
import { IDLE, isLive, type Pose, type RunView, reduce, starting } from "./reducer";
import { decodeTelemetry, NO_TELEMETRY } from "./telemetry";

/** The run that moves the robot now, or the last one that did. */
export const live = signal<RunView>(IDLE);

/** What the server says of it: program, world. Null until it is known. */
export const liveRun = signal<Run | null>(null);

const motion = new MotionBuffer();
/** Events that came while nobody could say yet where they belong. */
let waiting: RunEvent[] | null = null;
/** Stop was pressed before the run had a name. */
let stopWanted = false;

/** Where the robot is drawn at this moment of the screen's clock. */
export function livePose(now: number): Pose {
  return motion.at(now) ?? live.value.pose;
}

export function receive(event: RunEvent): void {
  if (waiting) {
    waiting.push(event);
    return;
  }
  if (event.run !== live.value.run) return;
  apply(event);
}

function apply(event: RunEvent): void {
  const next = reduce(live.value, event);
  if (next === live.value) return;
  if (event.type === "telemetry") motion.push(event.tick, next.pose, performance.now());
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

/** Starts a run; rejects with the server's words, and leaves what was shown before. */
export async function start(versionId: string, world: string): Promise<Run> {
  const before = live.value;
  waiting = [];
  stopWanted = false;
  live.value = starting(null);
  motion.reset();
  try {
    const run = await api.startRun(versionId, world);
    if (stopWanted) await api.stop(run.id);
    batch(() => {
      liveRun.value = run;
      live.value = starting(run.id);
    });
    return run;
  } catch (error) {
    live.value = before;
    throw error;
  } finally {
    release();
  }
}

/** Fetches what a run has done so far and follows it from there. */
export async function follow(runId: string): Promise<void> {
  waiting ??= [];
  try {
    const [run, events, telemetry] = await Promise.all([
      api.run(runId),
      api.runEvents(runId),
      api.runTelemetry(runId).then(decodeTelemetry, () => NO_TELEMETRY),
    ]);
    const { end } = new History(runId, events, telemetry);
    batch(() => {
      liveRun.value = run;
      live.value = end.phase === "idle" ? starting(runId) : end;
      motion.reset(end.pose);
    });
  } finally {
    release();
  }
}

function release(): void {
  const events = waiting ?? [];
  waiting = null;
  for (const event of events) receive(event);
}

/** The server said which run is live: catch up with it, or with the end of the one that was. */
export async function resync(runId: string | null): Promise<void> {
  const shown = live.value;
  if (runId) await follow(runId);
  else if (isLive(shown) && shown.run) await follow(shown.run);
}

export const pause = () => withRun(api.pause);
export const resume = () => withRun(api.resume);
export async function stop(): Promise<void> {
  stopWanted = live.value.run === null;
  await withRun(api.stop);
}
export const answerCapture = (result: string) => withRun((run) => api.answerCapture(run, result));

async function withRun(send: (run: string) => Promise<object>): Promise<void> {
  const { run } = live.value;
  if (run && isLive(live.value)) await send(run);
}
