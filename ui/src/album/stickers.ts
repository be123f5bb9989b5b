import { pictogramOf } from "../scene/mat/pictograms";
import { closed, corners, onCircle, type ShapeName, star } from "./shapes";

/**
 * A colour of a mark. `ground` is the sticker's own colour, for what is cut out of a mark; `inside` is
 * white in a mark of another colour.
 */
export type Ink = "white" | "sun" | "red" | "leaf" | "sky" | "dark" | "inside" | "ground";

/** A part of a picture, in a square of 100 by 100. */
export interface Mark {
  readonly d: string;
  readonly ink?: Ink;
  /** Width of the line; a mark without it is filled. */
  readonly line?: number;
  readonly transform?: string;
}

/** A hand that shows a letter of the manual alphabet. */
export interface HandMark {
  readonly letter: string;
  readonly x: number;
  readonly y: number;
  readonly size: number;
}

/** The drawing of a sticker. */
export interface StickerDrawing {
  readonly shape: ShapeName;
  readonly colour: string;
  readonly marks: readonly Mark[];
  readonly hands?: readonly HandMark[];
}

const GREEN = "#0a7a60";
const ORANGE = "#c2600a";
const PURPLE = "#7440ae";
const BLUE = "#2763ba";
const RED = "#bd2a1e";
const TEAL = "#0d6f88";
const PINK = "#ad2e72";
const BROWN = "#77502c";
const INDIGO = "#4348a6";
const OLIVE = "#547318";

const line = (d: string, width = 6, ink: Ink = "white"): Mark => ({ d, line: width, ink });
const fill = (d: string, ink: Ink = "white"): Mark => ({ d, ink });

/** The pictogram of a place, as on the floor, with its upper left corner at a point. */
const place = (name: string, x: number, y: number, scale: number): Mark => ({
  d: pictogramOf(name) ?? "",
  transform: `translate(${x} ${y}) scale(${scale})`,
});

const rect = (x: number, y: number, width: number, height: number, r = 0) =>
  `M${x + r} ${y}h${width - 2 * r}${bend(r, r, r)}v${height - 2 * r}${bend(r, -r, r)}h${2 * r - width}${bend(r, -r, -r)}v${2 * r - height}${bend(r, r, -r)}Z`;
const bend = (r: number, x: number, y: number) => (r ? `a${r} ${r} 0 0 1 ${x} ${y}` : "");
const disc = (x: number, y: number, r: number) =>
  `M${x - r} ${y}a${r} ${r} 0 1 1 ${2 * r} 0a${r} ${r} 0 1 1 ${-2 * r} 0Z`;

/** The robot from above, which drives to the right of its own drawing, turned by an angle. */
const robot = (x: number, y: number, angle = 0, scale = 1): Mark[] =>
  [
    fill(`${rect(-7, -10, 14, 4, 2)}${rect(-7, 6, 14, 4, 2)}`, "dark"),
    fill(rect(-10, -8, 20, 16, 4), "red"),
    fill("M7 0 -3 -5 -1 0 -3 5Z", "inside"),
  ].map((mark) => ({
    ...mark,
    transform: `translate(${x} ${y}) rotate(${angle}) scale(${scale})`,
  }));

/** A board of three by three cells, in a square of side 3 * cell. */
const board = (x: number, y: number, cell: number, width = 4): Mark =>
  line(
    [1, 2]
      .map((n) => n * cell)
      .map((at) => `M${x + at} ${y}v${3 * cell}M${x} ${y + at}h${3 * cell}`)
      .join(""),
    width,
  );
const cross = (x: number, y: number, r: number, ink: Ink = "white", width = 5): Mark =>
  line(`M${x - r} ${y - r}l${2 * r} ${2 * r}M${x + r} ${y - r}l${-2 * r} ${2 * r}`, width, ink);
const nought = (x: number, y: number, r: number, ink: Ink = "white", width = 5): Mark =>
  line(disc(x, y, r), width, ink);

/** Squares around the centre, which all have one corner there. */
const petals = (n: number, side: number) =>
  Array.from({ length: n }, (_, index) => (360 * index) / n).map((angle) =>
    closed([
      [50, 50],
      onCircle(side, angle - 45),
      onCircle(side * Math.SQRT2, angle),
      onCircle(side, angle + 45),
    ]),
  );

/** An arrow all around a square, from its lower left corner. */
const AROUND = "M30 62V36a6 6 0 0 1 6 -6h28a6 6 0 0 1 6 6v28a6 6 0 0 1 -6 6h-20";

/** The drawing of each shipped activity. */
const MISSIONS: Readonly<Record<string, StickerDrawing>> = {
  to_the_bakery: { shape: "circle", colour: ORANGE, marks: [place("padaria", 23, 22, 2.25)] },
  bread_and_back: {
    shape: "square",
    colour: TEAL,
    marks: [
      place("casa", 19, 24, 1.25),
      place("padaria", 51, 24, 1.25),
      line("M66 62v6a8 8 0 0 1 -8 8h-16a8 8 0 0 1 -8 -8v-4", 5, "sun"),
      fill("M34 56 26 67H42Z", "sun"),
    ],
  },
  around_the_corner: {
    shape: "hexagon",
    colour: GREEN,
    marks: [
      line("M27 70H54a8 8 0 0 0 8 -8V46", 8),
      fill("M62 28 75 48H49Z"),
      place("escola", 24, 30, 1.1),
    ],
  },
  left_right: {
    shape: "octagon",
    colour: OLIVE,
    marks: [
      place("praça", 33, 18, 1.45),
      line("M36 70H64", 7),
      fill("M22 70 37 59V81ZM78 70 63 59V81Z"),
    ],
  },
  dashed_line: {
    shape: "diamond",
    colour: BROWN,
    marks: [line("M22 38H78M22 62H78", 3), line("M26 50H36M45 50H55M64 50H74", 7, "sun")],
  },
  stairs: {
    shape: "burst",
    colour: PINK,
    marks: [fill("M25 73V63H37V52H49V41H61V30H75V73Z")],
  },
  square: {
    shape: "square",
    colour: GREEN,
    marks: [line(rect(31, 27, 42, 42), 8), ...robot(33, 69, 0, 1.15)],
  },
  triangle: {
    shape: "circle",
    colour: BLUE,
    marks: [line(closed(corners(3, 30).map(([x, y]) => [x, y + 5])), 8)],
  },
  polygon: {
    shape: "octagon",
    colour: PURPLE,
    marks: [
      line(closed(corners(8, 31, -67.5)), 5),
      line(closed(corners(5, 20)), 5, "sun"),
      fill(closed(corners(3, 9))),
    ],
  },
  star: {
    shape: "circle",
    colour: INDIGO,
    marks: [fill(closed(star(5, 32, 13)), "sun")],
  },
  lemniscate: {
    shape: "burst",
    colour: TEAL,
    marks: [line("M50 50C40 34 22 36 22 50S40 66 50 50 78 36 78 50 60 66 50 50Z", 8)],
  },
  letter: {
    shape: "burst",
    colour: BLUE,
    marks: [],
    hands: [{ letter: "L", x: 22, y: 21, size: 56 }],
  },
  flower: {
    shape: "flower",
    colour: PINK,
    marks: [...petals(6, 20).map((d) => line(d, 3.5)), fill(disc(50, 50, 7), "sun")],
  },
  sign_b: {
    shape: "square",
    colour: PURPLE,
    marks: [],
    hands: [{ letter: "B", x: 20, y: 19, size: 60 }],
  },
  b_or_a: {
    shape: "hexagon",
    colour: ORANGE,
    marks: [line(rect(26, 54, 19, 19), 4.5), line("M66 53 77 73H55Z", 4.5)],
    hands: [
      { letter: "B", x: 22, y: 22, size: 29 },
      { letter: "A", x: 51, y: 22, size: 29 },
    ],
  },
  until_b: {
    shape: "circle",
    colour: GREEN,
    marks: [line("M73.5 36A27 27 0 1 0 77 50", 5), fill("M80 25 79 44 62 37Z")],
    hands: [{ letter: "B", x: 33, y: 32, size: 35 }],
  },
  tic_tac_toe: {
    shape: "square",
    colour: BLUE,
    marks: [
      board(24, 24, 17.5),
      line("M33 33 62 62", 4, "sun"),
      fill("M71 71 56 66 66 56Z", "sun"),
    ],
  },
  cell_by_sign: {
    shape: "octagon",
    colour: RED,
    marks: [line(rect(52, 36, 27, 27, 3), 4), cross(65.5, 49.5, 7)],
    hands: [{ letter: "E", x: 18, y: 33, size: 33 }],
  },
  up_to_three_metres: {
    shape: "diamond",
    colour: INDIGO,
    marks: [
      line("M22 60H76M24 52V66M40.500 55V65M57 55V65M73.500 52V66", 4.5),
      place("meta", 58, 24, 1.1),
      ...robot(32, 43, 0, 0.85),
    ],
  },
  metres_by_fingers: {
    shape: "flower",
    colour: TEAL,
    marks: [line("M25 74H75M27 69V79M50 70V78M73 69V79", 4, "sun")],
    hands: [{ letter: "W", x: 28, y: 19, size: 45 }],
  },
  stop_before_wall: {
    shape: "square",
    colour: ORANGE,
    marks: [
      fill(
        "M64 22H78V30H64ZM64 33H70V42H64ZM73 33H78V42H73ZM64 45H78V54H64ZM64 57H70V66H64ZM73 57H78V66H73ZM64 69H78V77H64Z",
      ),
      line("M46 42a11 11 0 0 1 0 16M53 35a20 20 0 0 1 0 30", 4, "sun"),
      ...robot(31, 50, 0, 1.15),
    ],
  },
  to_the_red: {
    shape: "circle",
    colour: BROWN,
    marks: [
      fill(rect(20, 36, 15, 32), "sky"),
      fill(rect(35, 36, 15, 32), "leaf"),
      fill(rect(50, 36, 15, 32), "red"),
      fill(rect(65, 36, 15, 32), "sun"),
      line(rect(20, 36, 60, 32), 3),
      line("M35 37V67M50 37V67M65 37V67", 1.5, "ground"),
      fill("M57.500 50 49 33a10 10 0 1 1 17 0Z", "inside"),
      fill(disc(57.5, 27, 4), "ground"),
    ],
  },
  around_the_block: {
    shape: "hexagon",
    colour: BLUE,
    marks: [
      line(AROUND, 5, "sun"),
      fill("M46 62V78L33 70Z", "sun"),
      fill(rect(38, 39, 24, 19, 2)),
      line("M39 41 50 50 61 41", 3, "ground"),
    ],
  },
  maze: {
    shape: "hexagon",
    colour: PURPLE,
    marks: [line("M30 29H70V71H30V43M44 71V44H58V57", 6), fill(disc(37, 36, 4.5), "sun")],
  },
  slalom: {
    shape: "burst",
    colour: ORANGE,
    marks: [
      line("M21 50C28 26 36 30 40 50S52 74 60 50 72 30 79 50", 4.5, "sun"),
      fill("M30.500 40 37.500 58H23.500ZM50 40 57 58H43ZM69.500 40 76.500 58H62.500Z"),
    ],
  },
  pushing: {
    shape: "octagon",
    colour: GREEN,
    marks: [
      ...robot(32, 52, 0, 1.2),
      line(rect(49, 38, 28, 28, 2), 5),
      line("M51 40 75 64M75 40 51 64", 4),
    ],
  },
  x_against_list: {
    shape: "flower",
    colour: INDIGO,
    marks: [
      board(21, 31, 13, 3.5),
      cross(27.5, 37.5, 4, "sun", 3.5),
      cross(40.5, 50.5, 4, "sun", 3.5),
      nought(53.5, 37.5, 4, "white", 3.5),
      line("M68 36H80M68 45H80M68 54H80M68 63H80", 4),
    ],
  },
  two_teams: {
    shape: "circle",
    colour: RED,
    marks: [
      board(24, 24, 17.5, 3.5),
      cross(32.5, 32.5, 4.5, "white", 4),
      cross(50, 50, 4.5, "white", 4),
      nought(67.5, 32.5, 5, "sun", 4),
      nought(32.5, 67.5, 5, "sun", 4),
    ],
  },
};

/** The drawing of each sticker for character. */
const CHARACTER = {
  repair: {
    shape: "circle",
    colour: RED,
    marks: [
      {
        d: "M44 22a16 16 0 0 0 -3 29V78a9 9 0 0 0 18 0V51a16 16 0 0 0 -3 -29V38l-6 5 -6 -5Z",
        transform: "rotate(-42 50 50)",
      },
    ],
  },
  shorter: {
    shape: "square",
    colour: INDIGO,
    marks: [
      fill(rect(24, 26, 46, 15, 4), "sun"),
      fill(rect(24, 44, 38, 15, 4)),
      line(rect(26, 64, 28, 11, 4), 2.5),
      fill(disc(70, 67, 11)),
      line("M64 67H76", 4.5, "ground"),
    ],
  },
  careful: {
    shape: "hexagon",
    colour: OLIVE,
    marks: [
      fill("M50 20 75 28V50C75 66 64 76 50 82 36 76 25 66 25 50V28Z"),
      line("M35 43 41 38V61M51 49.500a7 11.500 0 1 0 14 0a7 11.500 0 1 0 -14 0Z", 5.5, "ground"),
    ],
  },
  taught: {
    shape: "flower",
    colour: PURPLE,
    marks: [{ d: closed(star(5, 13, 5.5)), ink: "sun", transform: "translate(22 -22)" }],
    hands: [{ letter: "V", x: 20, y: 24, size: 56 }],
  },
} as const satisfies Record<string, StickerDrawing>;

export type CharacterName = keyof typeof CHARACTER;

export const isCharacter = (name: string): name is CharacterName => name in CHARACTER;

/** For activities that a teacher made, and those of a newer release. */
const OTHER: StickerDrawing = {
  shape: "diamond",
  colour: TEAL,
  marks: [place("meta", 26, 24, 2.1)],
};

/** The drawing of the sticker of an activity, or of one for character. */
export const drawingOf = (name: string): StickerDrawing =>
  MISSIONS[name] ?? (isCharacter(name) ? CHARACTER[name] : OTHER);

/** Names of the activities that have a drawing of their own. */
export const DRAWN: readonly string[] = Object.keys(MISSIONS);
