import { texts } from "../i18n";
import { namedSign } from "../i18n/phrases";
import { type HandSide, handShape, type Landmark, type Piece } from "./hand_shape";
import { signs } from "./signs";
import drawn from "./signs.json";

/** Landmarks of a right hand in a mirror, for each sign with a drawing of its own. */
const DRAWN: Readonly<Record<string, readonly Landmark[]>> = drawn;

const OUTLINE = 2;

interface SignDrawingProps {
  sign: string;
  /** The side of the hand, as its owner sees it in a mirror. */
  hand?: HandSide;
  class?: string;
}

/**
 * Draws the hand that shows a sign: from the shipped landmarks, else from the samples of the class.
 * Without either it shows the sign's name.
 */
export function SignDrawing({ sign, hand = "right", class: more = "" }: SignDrawingProps) {
  const labels = texts.value.camera;
  const landmarks = landmarksOf(sign);
  const named = { sign: namedSign(sign, texts.value) };
  const name = landmarks ? labels.sign(named) : labels.noDrawing(named);
  return (
    <svg class={`sign-drawing ${more}`} viewBox="0 0 100 100" role="img" aria-label={name}>
      {landmarks ? (
        handShape(landmarks, hand).map((piece) => <Part key={piece.name} piece={piece} />)
      ) : (
        <Name name={sign} />
      )}
    </svg>
  );
}

/** Whether landmarks of the sign exist, so that the drawing shows more than the name. */
export function hasDrawing(sign: string): boolean {
  return landmarksOf(sign) !== null;
}

function landmarksOf(sign: string): readonly Landmark[] | null {
  return DRAWN[sign] ?? signs.value?.find(({ name }) => name === sign)?.landmarks ?? null;
}

/** Distance between two lines, in heights of a letter. */
const LINE = 1.1;
/** Width of a letter, in heights of a letter. */
const LETTER = 0.62;
const MAX_SIZE = 64;

/** A name in the largest size that fits, one line per word. */
function Name({ name }: { name: string }) {
  const parts = name.split(" ");
  const maxLength = Math.max(...parts.map(({ length }) => length));
  const size = Math.min(MAX_SIZE, 96 / (LETTER * maxLength), 96 / (LINE * parts.length));
  const first = 50 - ((parts.length - 1) * LINE * size) / 2;
  return parts.map((part, line) => (
    <text
      key={`${line} ${part}`}
      class="sign-drawing__name"
      x="50"
      y={first + line * LINE * size}
      font-size={size}
    >
      {part}
    </text>
  ));
}

function Part({ piece: { name, path, width, seam, edge } }: { piece: Piece }) {
  const kind = name === "palm" ? "sign-drawing__palm" : "sign-drawing__finger";
  const close = name === "palm" ? "Z" : "";
  return (
    <>
      <path
        class={`${kind} sign-drawing__outline`}
        d={edge ?? path + close}
        stroke-width={width + 2 * OUTLINE}
      />
      <path class={kind} d={path + close} stroke-width={width} />
      {seam && <path class={kind} d={seam} stroke-width={width} />}
    </>
  );
}
