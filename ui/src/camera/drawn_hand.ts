import { effect, signal } from "@preact/signals";
import type { CameraSightEvent } from "../api/model";
import type { HandSide } from "./hand_shape";
import { sight } from "./sight";

/**
 * The side of the hand in drawings. The user sets it, or the camera when its detected side changes.
 */
export const drawnHand = signal<HandSide>("right");

/**
 * Required number of equal detections in a row: a turning hand may briefly be detected as the other
 * side.
 */
const N_SIGHTS = 4;

let followed: HandSide | null = null;
let lastSide: HandSide | null = null;
let times = 0;

effect(() => {
  const side = sideOf(sight.value);
  if (side === null) return;
  times = side === lastSide ? times + 1 : 1;
  lastSide = side;
  if (times < N_SIGHTS || side === followed) return;
  followed = side;
  drawnHand.value = side;
});

/** The side of the detected hands; null if there is no hand, or one of each side. */
function sideOf(now: CameraSightEvent | null): HandSide | null {
  const [first, ...others] = now?.hands ?? [];
  const isOne = first && others.every(({ handedness }) => handedness === first.handedness);
  return isOne ? first.handedness : null;
}
