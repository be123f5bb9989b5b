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
  /** Stays until the camera works again, also while it is tried anew. */
  readonly problem: CameraProblem | null;
}

/** What the camera does. */
export const camera = signal<CameraNow>({ mode: "off", problem: null });
/** What it sees just now; null while it sees nothing, which is not the same as no hand. */
export const sight = signal<CameraSightEvent | null>(null);

/** With these there is a picture all the same, in which one sees what is wrong. */
const WITH_PICTURE = new Set(["camera_dark", "camera_black"]);

/** Whether there is a picture to show, or will be in a moment. */
export const hasPicture = computed(() => {
  const { problem } = camera.value;
  return problem === null || WITH_PICTURE.has(problem.code);
});

/** Width of the picture divided by its height; the last one known, so that nothing jumps. */
export const aspect = signal(4 / 3);

/** The recording of a sign that a class teaches, as it was told last; null before the first one. */
export const recording = signal<SignRecordingEvent | null>(null);

type CameraEvent = CameraSightEvent | CameraChangedEvent | SignRecordingEvent | SignsChangedEvent;

export function receive(event: CameraEvent): void {
  if (event.type === "sign_recording") {
    recording.value = event;
  } else if (event.type === "signs_changed") {
    void askForSigns(event.classroom);
  } else if (event.type === "camera_state") {
    const { state, code, params, message, remedy } = event;
    change(state, code === null ? null : { code, params, message, remedy });
  } else if (camera.peek().mode !== "off") {
    batch(() => {
      sight.value = event;
      aspect.value = event.aspect;
    });
  }
}

/** Asks how the camera is; events may have been missed, and none tells what was before. */
export async function refresh(): Promise<CameraStatus> {
  const status = await cameraApi.status();
  change(status.state, status.problem);
  return status;
}

/** The stream begins again. */
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

let isWarmedUp = false;

/** A program is open that will want the camera: gets it ready, once. What goes wrong, its state says. */
export function warmUp(): void {
  if (isWarmedUp) return;
  isWarmedUp = true;
  cameraApi.warmUp().catch(() => {
    isWarmedUp = false;
  });
}
