import type { DetectedHand } from "../api/model";
import { BONES } from "./hand_shape";
import { sight } from "./sight";

const HEIGHT = 100;

/** The detected hands as skeletons over the live picture. */
export function Skeleton() {
  const now = sight.value;
  if (!now) return null;
  const width = HEIGHT * now.aspect;
  const [one, other] = now.hands;
  return (
    <svg class="skeleton" viewBox={`0 0 ${width} ${HEIGHT}`} aria-hidden="true">
      {one && <Bones hand={one} width={width} />}
      {other && <Bones hand={other} width={width} />}
    </svg>
  );
}

function Bones({ hand, width }: { hand: DetectedHand; width: number }) {
  const places = hand.points.map(
    ([x = 0, y = 0]) => `${(x * width).toFixed(1)} ${(y * HEIGHT).toFixed(1)}`,
  );
  const bones = BONES.map((bone) => `M${bone.map((joint) => places[joint]).join("L")}`).join("");
  const joints = places.map((place) => `M${place}h0`).join("");
  return (
    <g class="skeleton__hand" data-sure={String(hand.sure)}>
      <path class="skeleton__edge" d={bones} />
      <path class="skeleton__bone" d={bones} />
      <path class="skeleton__joint" d={joints} />
    </g>
  );
}
