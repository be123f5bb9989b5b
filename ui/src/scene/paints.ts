/** Colours that programs and worlds name; they look the same on every floor. */
const PAINTS: Readonly<Record<string, string>> = {
  black: "#1d1b19",
  red: "#d7281f",
  orange: "#ee7d15",
  yellow: "#f4c81d",
  green: "#239a45",
  blue: "#2f6fe0",
  purple: "#9141c4",
  white: "#ffffff",
};

/** CSS colour of a paint; an unknown name gets the pen's default. */
export const paintOf = (name: string): string => PAINTS[name] ?? PAINTS.blue ?? "";

/** A line with less contrast than this to its background is hard to see. */
const LOST = 1.9;

/** Edge colour that keeps a paint visible on a background; null if no edge is needed. */
export function edgeOf(paint: string, ground: string, ink: string): string | null {
  return contrast(paint, ground) < LOST ? ink : null;
}

/** Contrast ratio of two colours `#rrggbb`, from 1 to 21, as WCAG defines it. */
export function contrast(one: string, other: string): number {
  const [a, b] = [luminance(one), luminance(other)];
  return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
}

function luminance(colour: string): number {
  const number = Number.parseInt(colour.slice(1), 16);
  const part = (shift: number) => {
    const value = ((number >> shift) & 255) / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  };
  return 0.2126 * part(16) + 0.7152 * part(8) + 0.0722 * part(0);
}
