import { computed, effect, signal } from "@preact/signals";
import type { CameraSightEvent, SeenSign } from "../../api/model";
import { type CameraNow, camera, sight } from "../../camera/sight";
import { signStateOf } from "../../camera/sign_state";

/** What is tried before a lesson, in the order in which one thing needs the other. */
export const POINTS = ["picture", "light", "distance", "sign"] as const;
export type Point = (typeof POINTS)[number];

/** How a point stands; `open` where nothing is known yet. */
export type PointStatus = "good" | "open" | "missing" | "frozen" | "dark" | "far" | "near";

/** Parts of the picture's height. A smaller hand has some 70 pixels or less, and is missed now and then. */
const MIN_HAND_SIZE = 0.15;
/** A larger one has no room to move. */
const MAX_HAND_SIZE = 0.85;

const DARK = new Set(["camera_dark", "camera_black"]);

/** Whether the camera serves for a lesson. What was seen of a hand stays true while the camera works. */
export class CameraCheck {
  /** The sign that was seen for certain last; "" before there was one. */
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

/** By the larger side of the hand; joints at the edge of the picture are near too. */
function distanceOf({ points }: SeenSign, aspect: number): PointStatus {
  const xs = points.map(([x = 0]) => x);
  const ys = points.map(([, y = 0]) => y);
  const [left, right] = [Math.min(...xs), Math.max(...xs)];
  const [top, bottom] = [Math.min(...ys), Math.max(...ys)];
  const size = Math.max((right - left) * aspect, bottom - top);
  if (size < MIN_HAND_SIZE) return "far";
  return size > MAX_HAND_SIZE || left < 0 || top < 0 || right > 1 || bottom > 1 ? "near" : "good";
}
