import { computed, effect, signal } from "@preact/signals";
import type { CameraSightEvent, SeenSign } from "../../api/model";
import { readingOf } from "../../camera/reading";
import { type CameraNow, camera, sight } from "../../camera/sight";

/** What is tried before a lesson, in the order in which one thing needs the other. */
export const POINTS = ["picture", "light", "distance", "sign"] as const;
export type Point = (typeof POINTS)[number];

/** How a point stands; `open` where nothing is known yet. */
export type Finding = "good" | "open" | "missing" | "frozen" | "dark" | "far" | "near";

/** Parts of the picture's height. A smaller hand has some 70 pixels or less, and is missed now and then. */
const SMALLEST_HAND = 0.15;
/** A larger one has no room to move. */
const LARGEST_HAND = 0.85;

const DARK = new Set(["camera_dark", "camera_black"]);

/** Whether the camera serves for a lesson. What was seen of a hand stays true while the camera works. */
export class CameraCheck {
  /** The sign that was seen for certain last; "" before there was one. */
  readonly sign = signal("");
  private readonly distance = signal<Finding>("open");
  readonly findings = computed<Readonly<Record<Point, Finding>>>(() => ({
    picture: pictureOf(camera.value),
    light: lightOf(camera.value),
    distance: this.distance.value,
    sign: this.sign.value ? "good" : "open",
  }));
  readonly isReady = computed(() => POINTS.every((point) => this.findings.value[point] === "good"));
  private readonly stop = effect(() => this.see(camera.value, sight.value));

  dispose(): void {
    this.stop();
  }

  private see({ mode }: CameraNow, now: CameraSightEvent | null): void {
    if (mode !== "on") {
      this.sign.value = "";
      this.distance.value = "open";
      return;
    }
    const [hand] = now?.hands ?? [];
    if (!now || !hand) return;
    this.distance.value = distanceOf(hand, now.aspect);
    const reading = readingOf(now);
    if (reading.kind === "sure") this.sign.value = reading.best;
  }
}

function pictureOf({ mode, problem }: CameraNow): Finding {
  if (problem?.code === "camera_frozen") return "frozen";
  if (problem && !DARK.has(problem.code)) return "missing";
  return mode === "on" || problem ? "good" : "open";
}

function lightOf({ mode, problem }: CameraNow): Finding {
  if (problem) return DARK.has(problem.code) ? "dark" : "open";
  return mode === "on" ? "good" : "open";
}

/** By the larger side of the hand; joints at the edge of the picture are near too. */
function distanceOf({ points }: SeenSign, aspect: number): Finding {
  const xs = points.map(([x = 0]) => x);
  const ys = points.map(([, y = 0]) => y);
  const [left, right] = [Math.min(...xs), Math.max(...xs)];
  const [top, bottom] = [Math.min(...ys), Math.max(...ys)];
  const size = Math.max((right - left) * aspect, bottom - top);
  if (size < SMALLEST_HAND) return "far";
  return size > LARGEST_HAND || left < 0 || top < 0 || right > 1 || bottom > 1 ? "near" : "good";
}
