import type {
  CaptureOf,
  GestureResultEvent,
  RunEndedEvent,
  RunEvent,
  TelemetryEvent,
} from "../api/model";
import { NOTHING, type Output, reduceOutput } from "./output";
import { EMPTY_TRAIL, extend, lastPoint, type Trail } from "./trail";

/** Phase of a run. */
export type Phase = "idle" | "starting" | "running" | "paused" | "finished" | "stopped" | "failed";

export interface Pose {
  readonly x: number;
  readonly y: number;
  readonly yaw: number;
}

/** A block that has started and not ended; the last one of the stack is the innermost. */
export interface ActiveBlock {
  readonly block: string | null;
  readonly pointer: string;
  readonly action: string;
  readonly amount: number | null;
  /** Number of the current loop round. NaN if rounds are too fast to count. */
  readonly round: number;
  /** Tick at which this round started. */
  readonly roundTick: number;
}

export interface Motion {
  readonly kind: string;
  readonly amount: number;
  readonly done: number;
  /** Tick at which it began; the sample of this tick still tells how far the motion before it had come. */
  readonly since: number;
}

export interface Speed {
  readonly linear: number;
  readonly angular: number;
}

export interface Capture {
  readonly block: string | null;
  readonly timeoutS: number;
  /** Seconds of real time until the timeout. */
  readonly leftS: number;
  readonly what: CaptureOf;
}

/** The answer to a capture. */
export interface CaptureAnswer {
  readonly what: CaptureOf;
  /** Name of the sign, or the number in digits; "" if none was recognised. */
  readonly label: string;
  /** Null after the timeout. */
  readonly by: CaptureBy | null;
  /** Confidence of the camera's prediction, 0 to 1; null if the camera did not answer. */
  readonly confidence: number | null;
  readonly tick: number;
}

export interface Captured extends CaptureAnswer {
  /** Number of the line of the dialogue that follows it. */
  readonly nextLine: number;
}

type CaptureBy = NonNullable<GestureResultEvent["by"]>;

export interface Ending {
  readonly reason: string | null;
  readonly params: Record<string, unknown>;
  readonly block: string | null;
  readonly durationS: number | null;
  readonly pathLengthM: number | null;
  /** True distance of the robot from its start, metres; null if unknown. */
  readonly closingErrorM: number | null;
  /** Distance of the robot's estimated pose from the start, metres. */
  readonly estimatedClosingErrorM: number | null;
}

/** Poses of movable boxes that have moved: x and y in metres, heading in radians, world frame, by index. */
export type BoxPoses = Readonly<Record<string, readonly number[]>>;

/** Everything that the page shows of a run at one tick, live or replayed. */
export interface RunView {
  readonly run: string | null;
  readonly phase: Phase;
  /** `seq` of the newest event applied, telemetry excluded. */
  readonly seq: number;
  readonly tick: number;
  readonly stack: readonly ActiveBlock[];
  /** The block that starts next, if the run is paused before one. */
  readonly next: string | null;
  /** The estimated pose. */
  readonly pose: Pose;
  /** The true pose; the same as `pose` while the true pose is unknown. */
  readonly truth: Pose;
  readonly setpoint: Pose;
  /** The true path. */
  readonly path: Trail;
  /** The desired path, from where the robot first left it; empty while the robot follows it. */
  readonly idealPath: Trail;
  readonly boxes: BoxPoses;
  readonly motion: Motion | null;
  /** Whether the program has commanded the robot to move. */
  readonly moved: boolean;
  /** The commanded velocity, m/s and rad/s. */
  readonly speed: Speed;
  readonly capture: Capture | null;
  readonly gesture: string | null;
  /** The last number shown by hand, -1 if a capture got none; null before any. */
  readonly number: number | null;
  /** The newest answer of a capture. */
  readonly captured: Captured | null;
  readonly output: Output;
  readonly ending: Ending | null;
}

/** Below this distance the estimated and the true pose count as equal. */
const SAME_M = 1e-6;

/** At lower speeds the robot counts as at rest, m/s and rad/s. */
export const STANDSTILL_MPS = 0.005;
export const STANDSTILL_RADPS = 0.01;

const isStandstill = (linear: number, angular: number) =>
  Math.abs(linear) <= STANDSTILL_MPS && Math.abs(angular) <= STANDSTILL_RADPS;

const AT_START: Pose = { x: 0, y: 0, yaw: 0 };
const AT_REST: Speed = { linear: 0, angular: 0 };

export const IDLE: RunView = {
  run: null,
  phase: "idle",
  seq: -1,
  tick: 0,
  stack: [],
  next: null,
  pose: AT_START,
  truth: AT_START,
  setpoint: AT_START,
  path: EMPTY_TRAIL,
  idealPath: EMPTY_TRAIL,
  boxes: {},
  motion: null,
  moved: false,
  speed: AT_REST,
  capture: null,
  gesture: null,
  number: null,
  captured: null,
  output: NOTHING,
  ending: null,
};

const NOT_STARTED = { pointer: "", action: "", amount: null, round: 0, roundTick: 0 };

export const starting = (run: string | null): RunView => ({ ...IDLE, run, phase: "starting" });

export const isLivePhase = (phase: Phase) =>
  phase === "starting" || phase === "running" || phase === "paused";

export const isLive = (view: RunView) => isLivePhase(view.phase);

/** The block before which the run is paused, else the innermost running one that has an id. */
export function runningBlock(view: RunView): ActiveBlock | null {
  if (view.next !== null) return { ...NOT_STARTED, block: view.next };
  return view.stack.findLast((entry) => entry.block !== null) ?? null;
}

export const activeBlockId = (view: RunView): string | null => runningBlock(view)?.block ?? null;

/** The state after an event. Events of another run and events already applied change nothing. */
export function reduce(view: RunView, event: RunEvent): RunView {
  if (event.run !== view.run) return view;
  if (event.type === "telemetry") return withTelemetry(view, event);
  if (event.seq <= view.seq) return view;
  const output = reduceOutput(view.output, event, [view.truth.x, view.truth.y]);
  const next = { ...view, output, seq: event.seq, tick: Math.max(view.tick, event.tick) };
  switch (event.type) {
    case "run_state":
      return { ...next, phase: event.state, next: heldBefore(event) };
    case "block_started":
      return withBlockStarted(next, event);
    case "block_ended":
      return withBlockEnded(next, event.pointer);
    case "capture_started":
      return { ...next, capture: captureOf(event) };
    case "countdown":
      return view.capture ? { ...next, capture: { ...view.capture, leftS: event.left_s } } : next;
    case "gesture_result":
      return { ...next, ...readBy(event), capture: null, captured: capturedSign(view, event) };
    case "watch":
      return { ...next, gesture: event.gesture || null, number: numberShown(view, event.number) };
    case "things":
      return { ...next, boxes: { ...view.boxes, ...event.boxes } };
    case "run_ended":
      return withRunEnded(next, event);
    default:
      return next;
  }
}

function captureOf({ block, timeout_s: s, what = "sign" }: CaptureStarted): Capture {
  return { block, timeoutS: s, leftS: s, what };
}

const NO_NUMBER = -1;

/** The sign or the number of a result; older recordings have signs only. */
function readBy({
  what,
  result,
}: GestureResultEvent): Pick<RunView, "gesture"> | Pick<RunView, "number"> {
  if (what !== "number") return { gesture: result };
  return { number: result === "" ? NO_NUMBER : Number(result) };
}

/** Before the first capture of a number, none is shown. */
function numberShown({ number }: RunView, given = NO_NUMBER): number | null {
  return number === null && given === NO_NUMBER ? null : given;
}

type CaptureStarted = Extract<RunEvent, { type: "capture_started" }>;

function capturedSign(view: RunView, event: GestureResultEvent): Captured | null {
  const answer = captureAnswerIn(event);
  if (!answer) return view.captured;
  const nextLine = (view.output.talk.at(-1)?.number ?? -1) + 1;
  return { ...answer, nextLine };
}

/** The answer to a capture that the event reports; null for any other event. */
export function captureAnswerIn(event: RunEvent): CaptureAnswer | null {
  if (event.type !== "gesture_result" || event.source !== "capture") return null;
  const { result: label, what = "sign", by = null, confidence = null, tick } = event;
  return { what, label, by, confidence, tick };
}

function withTelemetry(view: RunView, event: TelemetryEvent): RunView {
  if (event.tick < view.tick || view.ending) return view;
  const setpoint = { x: event.goal_x_m, y: event.goal_y_m, yaw: event.goal_yaw_rad };
  const pose = { x: event.x_m, y: event.y_m, yaw: event.yaw_rad };
  const truth = truthIn(event) ?? pose;
  return {
    ...view,
    tick: event.tick,
    pose,
    truth,
    setpoint,
    path: extend(view.path, [truth.x, truth.y]),
    idealPath: hasLeft(view, truth, setpoint)
      ? extend(view.idealPath, [setpoint.x, setpoint.y])
      : view.idealPath,
    output: reduceOutput(view.output, event, [truth.x, truth.y]),
    speed: { linear: event.command_v_mps, angular: event.command_omega_radps },
    motion: view.motion && withProgress(view.motion, event),
    moved: view.moved || !isStandstill(event.command_v_mps, event.command_omega_radps),
  };
}

function withProgress(motion: Motion, { tick, done }: TelemetryEvent): Motion {
  return done == null || tick <= motion.since ? motion : { ...motion, done };
}

/** A robot this far beside the desired path has left it; a smaller distance is not seen, m. */
const BESIDE_M = 0.03;

/** Whether the robot has left the desired path. */
function hasLeft({ idealPath }: RunView, truth: Pose, { x, y, yaw }: Pose): boolean {
  const [dx, dy] = [truth.x - x, truth.y - y];
  const beside = Math.abs(dy * Math.cos(yaw) - dx * Math.sin(yaw));
  return lastPoint(idealPath) !== undefined || beside > BESIDE_M;
}

/** Old recordings do not contain the true pose, and a real robot does not know it. */
function truthIn({ true_x_m: x, true_y_m: y, true_yaw_rad: yaw }: TelemetryEvent): Pose | null {
  return x == null || y == null || yaw == null ? null : { x, y, yaw };
}

type RunState = Extract<RunEvent, { type: "run_state" }>;

/** A person pauses a run inside a block; a step and a breakpoint pause it before one. */
function heldBefore({ state, cause, block }: RunState): string | null {
  const held = state === "paused" && (cause === "step" || cause === "breakpoint");
  return held ? (block ?? null) : null;
}

type BlockStarted = Extract<RunEvent, { type: "block_started" }>;

function withBlockStarted(view: RunView, event: BlockStarted): RunView {
  const { block, pointer, action, amount, tick } = event;
  const entry: ActiveBlock = { block, pointer, action, amount, round: 0, roundTick: -Infinity };
  return {
    ...view,
    stack: [...withRound(view.stack, pointer, tick), entry],
    motion: amount === null ? null : { kind: action, amount, done: 0, since: tick },
    moved: view.moved || (!!amount && action !== "wait"),
  };
}

/**
 * If the first command of a loop starts, counts a new round of the loop. For commands without
 * duration the robot reports only one start per tick, so rounds on consecutive ticks cannot be counted.
 */
function withRound(
  stack: readonly ActiveBlock[],
  pointer: string,
  tick: number,
): readonly ActiveBlock[] {
  const at = stack.findLastIndex((entry) => pointer === `${entry.pointer}/commands/0`);
  const loop = stack[at];
  if (!loop) return stack;
  const round = tick - loop.roundTick > 1 ? loop.round + 1 : Number.NaN;
  return stack.with(at, { ...loop, round, roundTick: tick });
}

function withBlockEnded(view: RunView, pointer: string): RunView {
  const at = view.stack.findLastIndex((entry) => entry.pointer === pointer);
  if (at < 0) return view;
  return { ...view, stack: view.stack.slice(0, at), motion: null, capture: null };
}

function withRunEnded(view: RunView, event: RunEndedEvent): RunView {
  return {
    ...view,
    phase: event.state,
    stack: [],
    next: null,
    motion: null,
    speed: AT_REST,
    capture: null,
    ...posesAtEnd(view, event),
    ending: {
      reason: event.reason,
      params: event.params,
      block: event.block,
      durationS: event.duration_s,
      pathLengthM: event.path_length_m,
      ...closingErrors(view, event),
    },
  };
}

/**
 * Earlier releases recorded only the estimated error, under the name of the true one. The true
 * error is then the distance of the last true pose, if the samples have one.
 */
function closingErrors(
  { pose, truth }: RunView,
  event: RunEndedEvent,
): Pick<Ending, "closingErrorM" | "estimatedClosingErrorM"> {
  const { closing_error_m: closingErrorM, estimated_closing_error_m: estimate } = event;
  if (estimate != null) return { closingErrorM, estimatedClosingErrorM: estimate };
  const isKnown = truth !== pose && closingErrorM !== null;
  const trueErrorM = isKnown ? Math.hypot(truth.x, truth.y) : null;
  return { closingErrorM: trueErrorM, estimatedClosingErrorM: closingErrorM };
}

/** The last event has only the estimated pose. It is also the true pose if both were equal before. */
function posesAtEnd(
  { pose, truth }: RunView,
  event: RunEndedEvent,
): Pick<RunView, "pose" | "truth"> {
  if (!event.pose) return { pose, truth };
  const last = { x: event.pose.x_m, y: event.pose.y_m, yaw: event.pose.yaw_rad };
  const same = Math.hypot(truth.x - pose.x, truth.y - pose.y) < SAME_M;
  return { pose: last, truth: same ? last : truth };
}
