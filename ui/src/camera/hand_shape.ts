/** A landmark: x to the right, y down, z away from the viewer; any unit, the same for all three. */
export type Landmark = readonly number[];
export type HandSide = "right" | "left";

/**
 * Number of landmarks in MediaPipe's hand model: wrist 0, thumb 1 to 4, then four per finger from
 * knuckle to tip.
 */
export const N_LANDMARKS = 21;
const PALM = [0, 1, 5, 9, 13, 17];
const FINGERS = [5, 9, 13, 17];

/** Lines between landmarks that show a hand as a skeleton. */
export const BONES: readonly (readonly number[])[] = [
  [0, 1, 2, 3, 4],
  ...FINGERS.map((knuckle) => [knuckle, knuckle + 1, knuckle + 2, knuckle + 3]),
  [0, 5, 9, 13, 17, 0],
];

/** A part of a drawn hand, in a square of 100 by 100. */
export interface Piece {
  readonly name: string;
  /** The path to stroke with `width`, on top of a wider outline; the palm is also filled. */
  readonly path: string;
  readonly width: number;
  /** A path without outline that hides the seam to the adjoining part. */
  readonly seam: string | null;
  /** The path of the outline, where it is not that of the whole part. */
  readonly edge: string | null;
}

type Flat = readonly [x: number, y: number];

/** Line widths, relative to the distance from the wrist to the middle finger's knuckle. */
const FINGER_WIDTH = 0.25;
const THUMB_WIDTH = 0.28;
const PALM_WIDTH = 0.3;
const SEAM = 0.4;
/** Where the outline of a thumb begins in the palm, of the way from its base to its first joint. */
const THUMB_EDGE = 0.55;
/** Cosine of the bend angle of a joint; below it the joint shows its crease. */
const CREASE_COS = 0.3;
/** Ends of the heel beside the wrist, relative to the distance from the first knuckle to the last. */
const HEEL = [0.26, -0.18];
const MARGIN = 4;
/** The least difference of depth, which only puts parts in order. */
const BEHIND = 1e-6;

interface Part {
  readonly depth: number;
  readonly piece: Piece;
}

/** The parts of a hand, the farthest first. `landmarks` are of a right hand in a mirror. */
export function handShape(landmarks: readonly Landmark[], side: HandSide): Piece[] {
  const unit = distance(at(landmarks, 0), at(landmarks, 9));
  const heel = heelOf(landmarks);
  const { place, scale } = intoSquare([...landmarks, ...heel], side, unit);
  const flat = landmarks.map(place);
  const part = (
    name: string,
    joints: readonly number[],
    width: number,
    from: Flat | null,
  ): Part => ({
    depth: mean(joints.map((joint) => at(landmarks, joint)[2] ?? 0)),
    piece: {
      name,
      path: line(joints.map((joint) => at(flat, joint))),
      width: width * unit * scale,
      seam: from && line([at(flat, joints[0] ?? 0), from]),
      edge: null,
    },
  });
  const palm = withHeel(part("palm", PALM, PALM_WIDTH, null), heel.map(place), flat);
  const middle = middleOf(PALM.map((joint) => at(flat, joint)));
  const fingers = FINGERS.flatMap((knuckle) => {
    const joints = [0, 1, 2, 3].map((n) => knuckle + n) as Four;
    const [first, second, third, tip] = joints;
    const into = towards(at(flat, first), middle, SEAM);
    if (isStraight(flat, joints, middle)) {
      const whole = part(`finger ${knuckle}`, joints, FINGER_WIDTH, into);
      const rim = (PALM_WIDTH * unit * scale) / 2;
      return outOf(
        palm,
        whole,
        flat,
        joints,
        rim / length(minus(at(flat, second), at(flat, first))),
      );
    }
    return [
      part(`finger ${knuckle}`, [first, second], FINGER_WIDTH, into),
      part(
        `tip ${knuckle}`,
        [second, third, tip],
        FINGER_WIDTH,
        seamAt(flat, second, first, third),
      ),
    ];
  });
  const base = part("thumb", [1, 2, 3], THUMB_WIDTH, towards(at(flat, 1), middle, SEAM));
  const thumb = [
    ...outOf(palm, base, flat, [1, 2, 3], THUMB_EDGE),
    part("thumb tip", [3, 4], THUMB_WIDTH, seamAt(flat, 3, 2, 4)),
  ];
  return [palm, ...fingers, ...thumb]
    .sort((one, other) => other.depth - one.depth)
    .map(({ piece }) => piece);
}

function withHeel(palm: Part, heel: readonly Flat[], flat: readonly Flat[]): Part {
  const rim = PALM.slice(1).map((joint) => at(flat, joint));
  return { ...palm, piece: { ...palm.piece, path: line([...heel, ...rim]) } };
}

/** The two ends of a palm's heel, as wide as a wrist: the landmarks have one point there, which would be a tip. */
function heelOf(landmarks: readonly Landmark[]): Landmark[] {
  const [wrist, first, last] = [at(landmarks, 0), at(landmarks, 5), at(landmarks, 17)];
  return HEEL.map((part) =>
    wrist.map((value, axis) => value + part * ((last[axis] ?? 0) - (first[axis] ?? 0))),
  );
}

/**
 * A part that grows out of the palm: its whole outline below the palm, so that both have one
 * contour, and above it only the outline from `begin` of its first bone on.
 */
function outOf(
  palm: Part,
  part: Part,
  flat: readonly Flat[],
  joints: readonly number[],
  begin: number,
): Part[] {
  if (part.depth >= palm.depth) return [part];
  const [first, second, ...others] = joints.map((joint) => at(flat, joint)) as [Flat, Flat];
  const edge = line([towards(first, second, Math.min(begin, 0.9)), second, ...others]);
  const { piece } = part;
  return [
    { depth: palm.depth + BEHIND, piece: { ...piece, name: `${piece.name} root`, seam: null } },
    { ...part, piece: { ...piece, edge } },
  ];
}

/** Whether a finger points away from the palm and no joint shows a crease. */
function isStraight(
  flat: readonly Flat[],
  [first, second, third, tip]: Four,
  middle: Flat,
): boolean {
  return (
    cosine(minus(at(flat, first), middle), minus(at(flat, second), at(flat, first))) > 0 &&
    seamAt(flat, second, first, third) !== null &&
    seamAt(flat, third, second, tip) !== null
  );
}

type Four = [number, number, number, number];

/** Scaling and mirroring that make the hand fill the square, the width of its fingers included. */
function intoSquare(landmarks: readonly Landmark[], side: HandSide, unit: number) {
  const turn = side === "left" ? -1 : 1;
  const xs = landmarks.map(([x = 0]) => turn * x);
  const ys = landmarks.map(([, y = 0]) => y);
  const [left, right, top, bottom] = [min(xs), max(xs), min(ys), max(ys)];
  const scale = (100 - 2 * MARGIN) / (Math.max(right - left, bottom - top) + PALM_WIDTH * unit);
  const place = ([x = 0, y = 0]: Landmark): Flat => [
    50 + (turn * x - (left + right) / 2) * scale,
    50 + (y - (top + bottom) / 2) * scale,
  ];
  return { place, scale };
}

/** The end point of the seam at a joint, in the part before it; null if the joint is bent. */
function seamAt(flat: readonly Flat[], joint: number, before: number, after: number): Flat | null {
  const [here, back, on] = [at(flat, joint), at(flat, before), at(flat, after)];
  return cosine(minus(here, back), minus(on, here)) > CREASE_COS ? towards(here, back, SEAM) : null;
}

const at = <T>(list: readonly T[], index: number): T => list[index] as T;
const min = (values: readonly number[]) => Math.min(...values);
const max = (values: readonly number[]) => Math.max(...values);
const mean = (values: readonly number[]) =>
  values.reduce((sum, one) => sum + one, 0) / values.length;
const minus = (one: Flat, other: Flat): Flat => [one[0] - other[0], one[1] - other[1]];
const cosine = (one: Flat, other: Flat) =>
  (one[0] * other[0] + one[1] * other[1]) / (Math.hypot(...one) * Math.hypot(...other) || 1);
const length = (one: Flat) => Math.hypot(...one);
const distance = (one: Landmark, other: Landmark) =>
  Math.hypot(...one.map((value, axis) => value - (other[axis] ?? 0)));
const towards = (from: Flat, to: Flat, part: number): Flat => [
  from[0] + part * (to[0] - from[0]),
  from[1] + part * (to[1] - from[1]),
];
const middleOf = (points: readonly Flat[]): Flat => [
  mean(points.map(([x]) => x)),
  mean(points.map(([, y]) => y)),
];
const line = (points: readonly Flat[]) =>
  `M${points.map((point) => point.map((value) => value.toFixed(1)).join(" ")).join("L")}`;
