import type { DetectedHand } from "../api/model";
import { BONES } from "./hand_shape";
import { sight } from "./sight";

const HEIGHT = 100;
const NAME_HEIGHT = 8;

/** The detected hands over the live picture: as skeletons, or as boxes with their sign from a detector. */
export function Skeleton() {
  const now = sight.value;
  if (!now) return null;
  const width = HEIGHT * now.aspect;
  const [one, other] = now.hands;
  return (
    <svg class="skeleton" viewBox={`0 0 ${width} ${HEIGHT}`} aria-hidden="true">
      {one && <HandDrawing hand={one} width={width} />}
      {other && <HandDrawing hand={other} width={width} />}
    </svg>
  );
}

interface HandDrawingProps {
  hand: DetectedHand;
  width: number;
}

const HandDrawing = (props: HandDrawingProps) =>
  props.hand.points.length > 0 ? <Bones {...props} /> : <SignBox {...props} />;

function SignBox({ hand, width }: HandDrawingProps) {
  const [left = 0, top = 0, right = 0, bottom = 0] = hand.box;
  const [x, y] = [left * width, top * HEIGHT];
  const size = { width: (right - left) * width, height: (bottom - top) * HEIGHT };
  return (
    <g class="skeleton__hand" data-sure={String(hand.sure)}>
      <rect class="skeleton__edge" x={x} y={y} {...size} />
      <rect class="skeleton__bone" x={x} y={y} {...size} />
      <text class="skeleton__name" x={x + 2} y={y + NAME_HEIGHT}>
        {hand.sure ? hand.best : `${hand.best} ?`}
      </text>
    </g>
  );
}

function Bones({ hand, width }: HandDrawingProps) {
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
