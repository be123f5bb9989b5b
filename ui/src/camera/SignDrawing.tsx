import { texts } from "../i18n";
import { type HandSide, handShape, type Landmark, type Piece } from "./hand_shape";
import drawn from "./signs.json";

/** Landmarks of a right hand in a mirror for each sign that can be drawn. */
const DRAWN: Readonly<Record<string, readonly Landmark[]>> = drawn;

const OUTLINE = 2;

interface SignDrawingProps {
  sign: string;
  /** Whose hand, as one sees it in a mirror. */
  hand?: HandSide;
  class?: string;
}

/** How a hand shows a sign; the letter itself where there is no drawing. */
export function SignDrawing({ sign, hand = "right", class: more = "" }: SignDrawingProps) {
  const words = texts.value.camera;
  const landmarks = DRAWN[sign];
  const name = landmarks ? words.sign(sign) : words.noDrawing(sign);
  return (
    <svg class={`sign-drawing ${more}`} viewBox="0 0 100 100" role="img" aria-label={name}>
      {landmarks ? (
        handShape(landmarks, hand).map((piece) => <Part key={piece.name} piece={piece} />)
      ) : (
        <text class="sign-drawing__letter" x="50" y="50">
          {sign}
        </text>
      )}
    </svg>
  );
}

function Part({ piece: { name, path, width, seam } }: { piece: Piece }) {
  const kind = name === "palm" ? "sign-drawing__palm" : "sign-drawing__finger";
  const close = name === "palm" ? "Z" : "";
  return (
    <>
      <path
        class={`${kind} sign-drawing__outline`}
        d={path + close}
        stroke-width={width + 2 * OUTLINE}
      />
      <path class={kind} d={path + close} stroke-width={width} />
      {seam && <path class={kind} d={seam} stroke-width={width} />}
    </>
  );
}
