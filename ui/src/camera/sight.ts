import { batch, computed, signal } from "@preact/signals";
import { cameraApi } from "../api/camera";
import type {
  CameraChangedEvent,
  CameraProblem,
  CameraSightEvent,
  CameraStatus,
  SignRecordingEvent,
  SignsChangedEvent,
} from "../api/model";
import { askForSigns, chooseSignsAgain } from "./signs";

export interface CameraNow {
  readonly mode: CameraStatus["state"];
  /** The last problem; it stays during new attempts, until the camera works again. */
  readonly problem: CameraProblem | null;
}

/** State of the camera. */
export const camera = signal<CameraNow>({ mode: "off", problem: null });
/** The result of the latest frame; null if there is no frame. A frame without hands is not null. */
export const sight = signal<CameraSightEvent | null>(null);

/** Problems for which the live picture is shown, because the user can recognise the cause in it. */
const WITH_PICTURE = new Set(["camera_dark", "camera_black"]);

/** Whether a live picture is shown, or will be when the camera is on. */
export const hasPicture = computed(() => {
  const { problem } = camera.value;
  return problem === null || WITH_PICTURE.has(problem.code);
});

/**
 * Aspect ratio (width / height) of the picture; keeps its last value, so that the layout does not
 * change.
 */
export const aspect = signal(4 / 3);

/** The latest progress of recording a taught sign; null before the first recording. */
export const recording = signal<SignRecordingEvent | null>(null);

type CameraEvent = CameraSightEvent | CameraChangedEvent | SignRecordingEvent | SignsChangedEvent;

export function receive(event: CameraEvent): void {
  if (event.type === "sign_recording") {
    recording.value = event;
  } else if (event.type === "signs_changed") {
    void askForSigns(event.classroom);
  } else if (event.type === "camera_state") {
    const { state, code, params, message, remedy } = event;
    nStateEvents += 1;
    change(state, code === null ? null : { code, params, message, remedy });
  } else if (camera.peek().mode !== "off") {
    batch(() => {
      sight.value = event;
      aspect.value = event.aspect;
    });
  }
}

/** Number of events about the camera's state that were received. */
let nStateEvents = 0;

/**
 * Requests the camera's state. Events may have been missed, and none repeats an earlier state. An
 * event that arrives before the response is at least as new, so the response then changes nothing.
 */
export async function refresh(): Promise<CameraStatus> {
  const before = nStateEvents;
  const status = await cameraApi.status();
  if (nStateEvents === before) change(status.state, status.problem);
  return status;
}

/** Updates the signals after the event stream has reconnected. */
export async function resync(): Promise<void> {
  void chooseSignsAgain();
  if (camera.peek().mode !== "off") await refresh();
}

function change(mode: CameraNow["mode"], problem: CameraProblem | null): void {
  const isClosed = mode === "off" || mode === "opening";
  batch(() => {
    camera.value = { mode, problem: isClosed ? camera.peek().problem : problem };
    if (isClosed || !hasPicture.value) sight.value = null;
  });
}

/** The app ends a camera process that nobody has asked for during five minutes. */
const WARM_PERIOD_MS = 60_000;

/**
 * Starts the camera process, and keeps it running until the returned function is called: while a
 * program that captures is open. Its failures arrive as camera state.
 */
export function warmUpRegularly(): () => void {
  const warmUp = () => {
    cameraApi.warmUp().catch(() => {}); // asked again after the period
  };
  warmUp();
  const timer = setInterval(warmUp, WARM_PERIOD_MS);
  return () => clearInterval(timer);
}
