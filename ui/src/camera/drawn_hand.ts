import { effect, signal } from "@preact/signals";
import type { CameraSightEvent } from "../api/model";
import type { HandSide } from "./hand_shape";
import { sight } from "./sight";

/** The hand that drawings show: the one that the camera saw last, or that was chosen since. */
export const drawnHand = signal<HandSide>("right");

/** So often in a row: a hand that turns may look like the other one for a moment. */
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

/** Which hand is in the picture; null for none, or both. */
function sideOf(now: CameraSightEvent | null): HandSide | null {
  const [first, ...others] = now?.hands ?? [];
  const isOne = first && others.every(({ handedness }) => handedness === first.handedness);
  return isOne ? first.handedness : null;
}
