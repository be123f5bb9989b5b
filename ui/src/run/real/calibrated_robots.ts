import { signal } from "@preact/signals";
import { calibrationApi } from "../../api/calibration";
import type { CalibratedRobot } from "../../api/model";

/** Robots of the simulator with the errors of a real one; null until they are loaded. */
export const calibratedRobots = signal<readonly CalibratedRobot[] | null>(null);

/** Loads the robots; they change when the teacher calibrates one or merges a file. */
export async function loadCalibratedRobots(): Promise<void> {
  calibratedRobots.value = await calibrationApi.robots();
}

/** The name of a calibrated robot; null if it was deleted or is not on this PC. */
export function calibratedTitle(id: string): string | null {
  return calibratedRobots.value?.find((one) => one.id === id)?.title ?? null;
}
