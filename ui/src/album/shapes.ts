/** Outlines of stickers, in a square of 100 by 100. */

type Point = readonly [x: number, y: number];

const CENTRE = 50;
const DEGREES = Math.PI / 180;
const UP = -90;

/** A point of a circle around the centre; angles in degrees, clockwise from the right. */
export const onCircle = (radius: number, angle: number): Point => [
  CENTRE + radius * Math.cos(angle * DEGREES),
  CENTRE + radius * Math.sin(angle * DEGREES),
];

const text = ([x, y]: Point) => `${x.toFixed(1)} ${y.toFixed(1)}`;
export const closed = (points: readonly Point[]) => `M${points.map(text).join("L")}Z`;

/** The corners of a regular polygon; the first one is at `from` degrees. */
export const corners = (n: number, radius: number, from = UP): Point[] =>
  Array.from({ length: n }, (_, index) => onCircle(radius, from + (360 * index) / n));

/** A star: its corners are on two circles in turn. */
export const star = (n: number, radius: number, inner: number): Point[] =>
  Array.from({ length: 2 * n }, (_, index) =>
    onCircle(index % 2 ? inner : radius, UP + (180 * index) / n),
  );

/** A flower: a circle of lobes. */
function lobes(n: number, radius: number, lobe: number): string {
  const [first, ...others] = corners(n, radius, UP - 180 / n);
  const arcs = [...others, first as Point].map((to) => `A${lobe} ${lobe} 0 0 1 ${text(to)}`);
  return `M${text(first as Point)}${arcs.join("")}Z`;
}

export const SHAPES = {
  circle: "M50 9A41 41 0 1 1 50 91A41 41 0 1 1 50 9Z",
  square:
    "M28 11H72A17 17 0 0 1 89 28V72A17 17 0 0 1 72 89H28A17 17 0 0 1 11 72V28A17 17 0 0 1 28 11Z",
  hexagon: closed(corners(6, 43)),
  octagon: closed(corners(8, 43, UP + 22.5)),
  diamond: closed(corners(4, 45)),
  burst: closed(star(14, 44, 36)),
  flower: lobes(8, 36, 15),
} as const;

export type ShapeName = keyof typeof SHAPES;
