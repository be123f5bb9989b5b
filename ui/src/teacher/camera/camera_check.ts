import { computed, effect, signal } from "@preact/signals";
import type { CameraSightEvent, DetectedHand } from "../../api/model";
import { type CameraNow, camera, sight } from "../../camera/sight";
import { signStateOf } from "../../camera/sign_state";

/** Points of the camera check, in order: each needs the points before it. */
export const POINTS = ["picture", "light", "distance", "sign"] as const;
export type Point = (typeof POINTS)[number];

/** Status of a point; `open` while nothing is known. */
export type PointStatus = "good" | "open" | "missing" | "frozen" | "dark" | "far" | "near";

/** Fraction of the picture's height. A smaller hand has about 70 pixels or less and is sometimes not detected. */
const MIN_HAND_SIZE = 0.15;
/** Fraction of the picture's height. A larger hand cannot move without leaving the picture. */
const MAX_HAND_SIZE = 0.85;

const DARK = new Set(["camera_dark", "camera_black"]);

/** Checks whether the camera is good enough for a lesson. Results of a hand stay while the camera works. */
export class CameraCheck {
  /** The last sign that was recognised with certainty; "" before the first. */
  readonly sign = signal("");
  private readonly distance = signal<PointStatus>("open");
  readonly statuses = computed<Readonly<Record<Point, PointStatus>>>(() => ({
    picture: pictureOf(camera.value),
    light: lightOf(camera.value),
    distance: this.distance.value,
    sign: this.sign.value ? "good" : "open",
  }));
  readonly isReady = computed(() => POINTS.every((point) => this.statuses.value[point] === "good"));
  private readonly stop = effect(() => this.update(camera.value, sight.value));

  dispose(): void {
    this.stop();
  }

  private update({ mode }: CameraNow, now: CameraSightEvent | null): void {
    if (mode !== "on") {
      this.sign.value = "";
      this.distance.value = "open";
      return;
    }
    const [hand] = now?.hands ?? [];
    if (!now || !hand) return;
    this.distance.value = distanceOf(hand, now.aspect);
    const reading = signStateOf(now);
    if (reading.kind === "sure") this.sign.value = reading.best;
  }
}

function pictureOf({ mode, problem }: CameraNow): PointStatus {
  if (problem?.code === "camera_frozen") return "frozen";
  if (problem && !DARK.has(problem.code)) return "missing";
  return mode === "on" || problem ? "good" : "open";
}

function lightOf({ mode, problem }: CameraNow): PointStatus {
  if (problem) return DARK.has(problem.code) ? "dark" : "open";
  return mode === "on" ? "good" : "open";
}

/** Rates the distance by the larger side of the hand. A hand that leaves the picture is near too. */
function distanceOf({ box }: DetectedHand, aspect: number): PointStatus {
  const [left = 0, top = 0, right = 0, bottom = 0] = box;
  const size = Math.max((right - left) * aspect, bottom - top);
  if (size < MIN_HAND_SIZE) return "far";
  return size > MAX_HAND_SIZE || left < 0 || top < 0 || right > 1 || bottom > 1 ? "near" : "good";
}
