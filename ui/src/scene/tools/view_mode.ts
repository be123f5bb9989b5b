import { signal } from "@preact/signals";

export type CameraMode = "orbit" | "follow" | "eye";
export const CAMERA_MODES: readonly CameraMode[] = ["orbit", "follow", "eye"];

/** Why the floor is not shown in 3D. */
export type SolidProblem = "no_webgl" | "lost" | "not_fetched";

/** Whether floors are shown in 3D. Stays until the page is closed. */
export const isSolid = signal(false);

/** The camera of floors in 3D. */
export const cameraMode = signal<CameraMode>("orbit");

/** Why 3D ended and on which floor, until the message is closed; null if it did not. */
export const solidEnd = signal<{ readonly problem: SolidProblem; readonly floor: object } | null>(
  null,
);

export function showSolid(isOn: boolean): void {
  solidEnd.value = null;
  isSolid.value = isOn;
}

/** Returns to 2D and says why; of several floors on one screen, the first one says it. */
export function endSolid(problem: SolidProblem, floor: object): void {
  if (!isSolid.peek()) return;
  isSolid.value = false;
  solidEnd.value = { problem, floor };
}
