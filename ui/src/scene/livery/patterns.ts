import type { ROBOT_PATTERNS } from "../../api/declared";

/** The pattern of a robot without a group, and of a plain robot. */
export const PLAIN = "plain";

/** Drawing of a pattern: the data of an SVG path, filled, or drawn as a line of the given width. */
export interface Pattern {
  readonly path: string;
  readonly line?: number;
}

type PatternName = (typeof ROBOT_PATTERNS)[number];

/** Half the side of a check; distance between dots and between waves. */
const CHECK = 0.17;
const DOTS = 0.4;
const WAVES = 0.4;

/** Places of a row from -1.2 to 1.2, which covers the whole hull. */
const row = (gap: number, begin = -1.2) =>
  Array.from({ length: Math.ceil(2.4 / gap) + 1 }, (_, index) => begin + index * gap);

/**
 * Drawings by name, in the robot's frame: x ahead, y to the left, from -1 to 1, of which the hull cuts out its
 * outline. Canvas, small pictures and 3D share them.
 */
export const PATTERNS: Readonly<Record<PatternName, Pattern | null>> = {
  waves: { path: waves(), line: 0.12 },
  stripes: {
    path: row(0.42, -2.4)
      .concat(row(0.42, 0.12))
      .map((x) => `M${at(x)} -1.2l2.4 2.4`)
      .join(""),
    line: 0.13,
  },
  dots: { path: dots() },
  checks: { path: checks() },
  star: { path: star(1.02, 0.4) },
  plain: null,
};

/** The drawing of a pattern; null for a plain robot, also for a pattern of a newer release. */
export function patternOf(name: string): Pattern | null {
  return Object.hasOwn(PATTERNS, name) ? PATTERNS[name as PatternName] : null;
}

function waves(): string {
  const waveLine = (y: number) => `M-1.2 ${at(y)}q.15-.26.3 0t.3 0t.3 0t.3 0t.3 0t.3 0t.3 0t.3 0`;
  return row(WAVES, -1.2).map(waveLine).join("");
}

function dots(): string {
  const radius = 0.11;
  const dot = (x: number, y: number) =>
    `M${at(x - radius)} ${at(y)}a${radius} ${radius} 0 1 0 ${2 * radius} 0a${radius} ${radius} 0 1 0 ${-2 * radius} 0z`;
  return row(DOTS)
    .flatMap((x, index) => row(DOTS, index % 2 ? -1.2 : -1).map((y) => dot(x, y)))
    .join("");
}

function checks(): string {
  return row(2 * CHECK)
    .flatMap((x, index) =>
      row(4 * CHECK, index % 2 ? -1.2 : -1.2 + 2 * CHECK).map(
        (y) => `M${at(x)} ${at(y)}h${2 * CHECK}v${2 * CHECK}h${-2 * CHECK}z`,
      ),
    )
    .join("");
}

/** A star with five points, one of them ahead. */
function star(outer: number, inner: number): string {
  const corners = Array.from({ length: 10 }, (_, index) => {
    const radius = index % 2 ? inner : outer;
    const angle = (index * Math.PI) / 5;
    return `${at(radius * Math.cos(angle))} ${at(radius * Math.sin(angle))}`;
  });
  return `M${corners.join("L")}z`;
}

function at(value: number): string {
  return value.toFixed(3);
}
