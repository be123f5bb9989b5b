/**
 * One shape of a drawing: an SVG path in metres, x right and y up, around the centre of what is drawn. Colours are
 * `#rrggbb`.
 */
export interface Part {
  readonly d: string;
  readonly fill?: string;
  readonly line?: string;
  /** Width of the line, metres. */
  readonly width?: number;
  readonly dash?: readonly number[];
}

/** Draws something of a size in metres. The drawing of a box fills the size exactly. `colour` is that of a print. */
export type Drawing = (width: number, depth: number, colour: string) => Part[];

/** A rectangle around (x, y) with rounded corners. */
export function rect(x: number, y: number, width: number, depth: number, radius = 0): string {
  const r = Math.min(radius, width / 2, depth / 2);
  const [left, right, bottom, top] = [x - width / 2, x + width / 2, y - depth / 2, y + depth / 2];
  if (r === 0) return `M${left} ${bottom}H${right}V${top}H${left}Z`;
  const to = (dx: number, dy: number) => `a${r} ${r} 0 0 1 ${dx * r} ${dy * r}`;
  return `M${left + r} ${bottom}H${right - r}${to(1, 1)}V${top - r}${to(-1, 1)}H${left + r}${to(-1, -1)}V${bottom + r}${to(1, -1)}Z`;
}

/** An ellipse around (x, y); a circle without `ry`. */
export const oval = (x: number, y: number, rx: number, ry = rx): string =>
  `M${x - rx} ${y}a${rx} ${ry} 0 1 0 ${2 * rx} 0a${rx} ${ry} 0 1 0 ${-2 * rx} 0Z`;

/** Lines across a rectangle around the centre, `every` metres apart, along its longer side if `along`. */
export function stripes(width: number, depth: number, every: number, along: boolean): string {
  const isWide = width >= depth === along;
  const across = isWide ? depth : width;
  const n = Math.max(1, Math.round(across / every));
  const places = Array.from({ length: n - 1 }, (_, i) => -across / 2 + ((i + 1) * across) / n);
  return places
    .map((at) =>
      isWide ? `M${-width / 2} ${at}H${width / 2}` : `M${at} ${-depth / 2}V${depth / 2}`,
    )
    .join("");
}

/** Mixes two colours `#rrggbb`; `part` 0 is the first, 1 the second. */
export function mixed(one: string, other: string, part: number): string {
  const [a, b] = [Number.parseInt(one.slice(1), 16), Number.parseInt(other.slice(1), 16)];
  const channel = (shift: number) => {
    const [from, to] = [(a >> shift) & 255, (b >> shift) & 255];
    return Math.round(from + (to - from) * part);
  };
  const number = (channel(16) << 16) | (channel(8) << 8) | channel(0);
  return `#${number.toString(16).padStart(6, "0")}`;
}
