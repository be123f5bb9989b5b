import { batch, computed, signal } from "@preact/signals";
import { api } from "../api/client";
import { ApiError } from "../api/errors";
import type {
  CommandAnswer,
  LiveCommand,
  RangesEvent,
  Run,
  RunEvent,
  RunOptions,
  RunWithVersion,
} from "../api/model";
import { CaptureShow } from "./captures/capture_show";
import { record } from "./live_record";
import { MotionBuffer } from "./motion_buffer";
import { RecordedStates } from "./recorded_states";
import {
  captureAnswerIn,
  IDLE,
  isLive,
  type Pose,
  type RunView,
  reduce,
  starting,
} from "./reducer";
import { soundBetween } from "./sounds/run_sounds";
import { beep, playSound } from "./sounds/sound";
import { endSpeech, speak } from "./sounds/speech";
import { decodeTelemetry, NO_TELEMETRY } from "./telemetry";

/** State of the live run, or of the last one. */
export const live = signal<RunView>(IDLE);

/** The server's record of that run: program, world, and the version if requested. Null until it is loaded. */
export const liveRun = signal<Run | RunWithVersion | null>(null);

/** What captures of the run get, as it happens, or as the group asks to see it again. */
export const captureShow = new CaptureShow();

export const isRunning = computed(() => isLive(live.value));

const motion = new MotionBuffer();
/** Number of pending requests whose responses decide which run events belong to; events are queued meanwhile. */
let pendingRequests = 0;
let queuedEvents: RunEvent[] = [];
/** Events that already triggered a `follow`. Each triggers only one, so that a failing server is not polled forever. */
const tried = new WeakSet<RunEvent>();
/** Sequence number of requests; only the newest response is shown. */
let newestRequest = 0;
/** Stop was pressed before the run had an id. */
let stopRequested = false;

/**
 * The newest view, waiting for the next redraw: a program can send thousands of block events a second, and the page is
 * redrawn sixty times a second.
 */
let waiting: RunView | null = null;
let timer: ReturnType<typeof setTimeout> | undefined;
let shownAt = Number.NEGATIVE_INFINITY;
const FRAME_MS = 16;

const newest = (): RunView => waiting ?? live.value;

/** Shows a view immediately and drops the waiting one. */
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

/** The pose at which the robot is drawn at a time of the screen's clock. */
export function livePose(now: number): Pose {
  return motion.at(now) ?? live.value.truth;
}

/** Newest sensor distances, while the page subscribes to them. */
export const ranges = signal<RangesEvent | null>(null);

export function receive(event: RunEvent): void {
  const view = newest();
  if (event.type === "ranges") {
    if (event.run === view.run) ranges.value = event;
  } else if (pendingRequests > 0) queuedEvents.push(event);
  else if (event.run === view.run) apply(event);
  else if (!isLive(view) && isSignOfLife(event) && !tried.has(event)) {
    // started in another window
    tried.add(event);
    queuedEvents.push(event);
    // if this fails, the next such event tries again
    follow(event.run).catch(() => {});
  }
}

/** Telemetry is too frequent to query the server for each sample, and a run that ended is not followed. */
const isSignOfLife = ({ type }: RunEvent) => type !== "telemetry" && type !== "run_ended";

function apply(event: RunEvent): void {
  const before = newest();
  const next = reduce(before, event);
  if (next === before) return;
  record.add(event);
  if (event.type === "telemetry") motion.push(event.tick, next.truth, performance.now());
  const answer = captureAnswerIn(event);
  if (answer) captureShow.start([answer]);
  makeSound(event, before, next);
  showSoon(next);
}

function makeSound(event: RunEvent, before: RunView, now: RunView): void {
  if (event.type === "beeped") beep();
  if (event.type === "said") speak(event.text);
  if (now.phase === "stopped") endSpeech();
  const sound = soundBetween(before, now);
  if (sound) playSound(sound);
}

/** Clears the run and shows the robot at the start. */
export function clear(): void {
  if (isLive(newest())) return;
  batch(() => {
    show(IDLE);
    liveRun.value = null;
    captureShow.clear();
    motion.reset();
    record.begin();
  });
}

/** Starts a run. Rejects with the server's message, then shows the previous state or the run that is in the way. */
export function start(versionId: string, world: string, debugging: RunOptions = {}): Promise<Run> {
  const before = newest();
  const nameless = starting(null);
  newestRequest++; // responses about an earlier run are no longer shown
  stopRequested = false;
  show(nameless);
  captureShow.clear();
  motion.reset();
  record.begin();
  return queueingEvents(async () => {
    try {
      const run = await api.startRun(versionId, world, debugging);
      newestRequest++;
      batch(() => {
        liveRun.value = run;
        if (newest().run !== run.id) show(starting(run.id));
      });
      if (stopRequested) await stop();
      return run;
    } catch (error) {
      if (newest() === nameless) show(before);
      if (isCode(error, "run_in_progress")) await adoptServerRun(stopRequested);
      throw error;
    }
  });
}

/** Loads the events of a run so far and shows the run from there on. */
export function follow(runId: string): Promise<void> {
  const request = ++newestRequest;
  return queueingEvents(async () => {
    const [run, events, telemetry] = await Promise.all([
      api.run(runId),
      api.runEvents(runId),
      api.runTelemetry(runId).then(decodeTelemetry, () => NO_TELEMETRY),
    ]);
    if (request !== newestRequest) return;
    const { end } = new RecordedStates(runId, events, telemetry);
    batch(() => {
      liveRun.value = run;
      show(end.phase === "idle" ? starting(runId) : end);
      motion.reset(end.truth);
      record.load(events, telemetry);
    });
  });
}

/** Queues events during `work`, then replays them; the reducer ignores those that are already applied. */
async function queueingEvents<T>(work: () => Promise<T>): Promise<T> {
  pendingRequests++;
  try {
    return await work();
  } finally {
    if (--pendingRequests === 0) {
      const events = queuedEvents;
      queuedEvents = [];
      for (const event of events) receive(event);
      catchUp();
    }
  }
}

/** Loads the run that the server reports as live; for null, loads the end of the run that was live. */
export async function resync(runId: string | null): Promise<void> {
  const shown = newest();
  if (runId) await follow(runId);
  else if (isLive(shown) && shown.run) await follow(shown.run);
}

export type { RunOptions };

/** Sends a command to the live run; resolves to null if no run is live, or if it has just ended. */
export async function command(liveCommand: LiveCommand): Promise<CommandAnswer | null> {
  if (liveCommand.do === "speed") motion.setSpeed(liveCommand.factor);
  if (liveCommand.do === "subscribe" && liveCommand.sensors.length === 0) ranges.value = null;
  const view = newest();
  if (view.run === null || !isLive(view)) return null;
  try {
    return await api.command(view.run, liveCommand);
  } catch (error) {
    if (!isCode(error, "run_not_live")) throw error;
    await adoptServerRun(false);
    return null;
  }
}

/** Stops the robot, even if another client started the run and this page does not know the run yet. */
export async function stop(): Promise<void> {
  const view = newest();
  if (!isLive(view)) await adoptServerRun(true);
  else if (view.run === null) stopRequested = true;
  else {
    try {
      await api.command(view.run, STOP);
    } catch (error) {
      if (!isCode(error, "run_not_live")) throw error;
      await adoptServerRun(true);
    }
  }
}

/** Asks the server which run is live, stops that run if `toStop`, and shows it. */
async function adoptServerRun(toStop: boolean): Promise<void> {
  const { run } = await api.status();
  if (run && toStop) {
    await api.command(run, STOP).catch((error) => {
      // the run ended in the meantime
      if (!isCode(error, "run_not_live")) throw error;
    });
  }
  await resync(run);
}

const STOP: LiveCommand = { do: "stop" };

const isCode = (error: unknown, code: string) => error instanceof ApiError && error.code === code;
