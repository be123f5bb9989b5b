import { type HandSide, handShape, type Landmark } from "../camera/hand_shape";
import landmarksOfLetters from "../camera/signs.json";
import { SHAPES } from "./shapes";
import { drawingOf, type HandMark, type Ink, type Mark } from "./stickers";

const LETTERS: Readonly<Record<string, readonly Landmark[]>> = landmarksOfLetters;
const SIDE: HandSide = "right";

/** The same in every theme: a sticker is printed. */
const INKS: Readonly<Record<Exclude<Ink, "ground">, string>> = {
  white: "#ffffff",
  inside: "#ffffff",
  sun: "#ffd23f",
  red: "#d7281f",
  leaf: "#5cae3f",
  sky: "#69b7e8",
  dark: "#26221c",
};
const HAND = "#f0dcb8";
const HAND_LINE = "#26221c";
const HAND_OUTLINE = 2.5;
const RIM = 7;
const EDGE = 9;
/** Stickers are pasted by hand: each is turned a little, always in the same way. */
const TILTS_DEG = [-5, 3, -2, 5, 1, -4, 4];

interface StickerPictureProps {
  /** Name of the activity, or of a sticker for character. */
  name: string;
  /** Whether it is a sticker, or only the outline of an empty place. */
  won: boolean;
}

/** A drawn sticker, or its empty place: a dashed outline with the faded picture. */
export function StickerPicture({ name, won }: StickerPictureProps) {
  const { shape, colour, marks, hands = [] } = drawingOf(name);
  const inkOf = (ink: Ink = "white") => {
    if (won) return ink === "ground" ? colour : INKS[ink];
    return ink === "ground" || ink === "inside" ? "var(--ground)" : "currentColor";
  };
  return (
    <svg class="sticker" viewBox="0 0 100 100" data-won={won} aria-hidden="true">
      <g transform={won ? `rotate(${tiltOf(name)} 50 50)` : undefined}>
        {won && <path class="sticker__edge" d={SHAPES[shape]} stroke-width={EDGE} />}
        {won && <path class="sticker__rim" d={SHAPES[shape]} stroke-width={RIM} />}
        <path class="sticker__shape" d={SHAPES[shape]} fill={won ? colour : "none"} />
        <g class="sticker__marks">
          {marks.map((mark) => (
            <Drawn key={`${mark.d} ${mark.transform}`} mark={mark} ink={inkOf(mark.ink)} />
          ))}
          {hands.map((hand) => (
            <Hand key={hand.letter} hand={hand} won={won} />
          ))}
        </g>
      </g>
    </svg>
  );
}

const tiltOf = (name: string) => TILTS_DEG[name.length % TILTS_DEG.length] ?? 0;

function Drawn({ mark, ink }: { mark: Mark; ink: string }) {
  const { d, line, transform } = mark;
  if (line === undefined)
    return <path d={d} fill={ink} fill-rule="evenodd" transform={transform} />;
  return <path d={d} fill="none" stroke={ink} stroke-width={line} transform={transform} />;
}

/** A hand with an outline: all outlines of a part lie below its colour. */
function Hand({ hand: { letter, x, y, size }, won }: { hand: HandMark; won: boolean }) {
  const [skin, outline] = won ? [HAND, HAND_LINE] : ["var(--ground)", "currentColor"];
  return (
    <g transform={`translate(${x} ${y}) scale(${size / 100})`}>
      {handShape(LETTERS[letter] ?? [], SIDE).map(({ name, path, width, seam, edge }) => {
        const isPalm = name === "palm";
        const d = isPalm ? `${path}Z` : path;
        return (
          <g key={name} fill={isPalm ? skin : "none"} stroke={skin} stroke-width={width}>
            <path d={edge ?? d} stroke={outline} stroke-width={width + 2 * HAND_OUTLINE} />
            <path d={d} />
            {seam && <path d={seam} />}
          </g>
        );
      })}
    </g>
  );
}
