import type { World } from "../../api/model";
import { paintOf } from "../paints";
import { ridge } from "./boxes";
import { type Drawing, mixed, oval, type Part, rect, stripes } from "./parts";

export type Printed = NonNullable<World["prints"]>[number];
export type PrintKind = Printed["kind"];

const PAVEMENT_M = 0.1;
const PAVED = "#efe8db";
const ASPHALT = "#cbc6bc";
const PAINTED = "#ffffff";

const pavement: Drawing = (width, depth) => [
  { d: rect(0, 0, width + 2 * PAVEMENT_M, depth + 2 * PAVEMENT_M, 0.2), fill: PAVED },
];

const asphalt: Drawing = (width, depth) => [{ d: rect(0, 0, width, depth, 0.12), fill: ASPHALT }];

/** The dashes down the middle; they end before the streets at both ends. */
const dashes: Drawing = (width, depth) => {
  const isWide = width >= depth;
  const half = Math.max(0, (isWide ? width - depth : depth - width) / 2);
  const d = isWide ? `M${-half} 0H${half}` : `M0 ${-half}V${half}`;
  return [{ d, line: PAINTED, width: 0.045, dash: [0.2, 0.16] }];
};

/** White bars across a street, along its way. */
const crossing: Drawing = (width, depth) => {
  const isWide = width >= depth;
  const [along, across] = isWide ? [width, depth] : [depth, width];
  const n = Math.max(2, Math.round(along / 0.14));
  const bar = (index: number) => {
    const at = -along / 2 + ((index + 0.5) * along) / n;
    const thick = (0.55 * along) / n;
    return isWide ? rect(at, 0, thick, across) : rect(0, at, across, thick);
  };
  return [{ d: Array.from({ length: n }, (_, i) => bar(i)).join(""), fill: PAINTED }];
};

/** Paler than any colour that the floor sensor reads. */
const PALE = 0.5;

const roof: Drawing = (width, depth, colour) => {
  const pale = mixed(colour, "#ffffff", PALE);
  return [
    { d: rect(0, 0, width, depth, 0.04), fill: pale },
    {
      d: stripes(width, depth, 0.16, false),
      line: mixed(pale, colour, 0.25),
      width: 0.015,
    },
    ridge(width, depth, PAINTED),
  ];
};

const rug: Drawing = (width, depth, colour) => {
  const pale = mixed(colour, "#ffffff", PALE);
  return [
    { d: rect(0, 0, width, depth, 0.08), fill: pale },
    { d: rect(0, 0, 0.85 * width, 0.85 * depth, 0.05), line: PAINTED, width: 0.04 },
  ];
};

const garden: Drawing = (width, depth) => [
  { d: rect(0, 0, width, depth, 0.15), fill: "#cfe5bd" },
  { d: spots(width, depth, 0.55, 0.1), fill: "#b4d69e" },
  { d: spots(width, depth, 0.55, 0.045), fill: "#f3d7dd" },
];

const pond: Drawing = (width, depth) => {
  const ring = (part: number): string => oval(0, 0, (part * width) / 2, (part * depth) / 2);
  return [
    { d: ring(1), fill: "#f3ead8" },
    { d: ring(0.8), fill: "#b9dfee" },
    { d: ring(0.45), line: "#dcf0f7", width: 0.03 },
    { d: ring(0.2), line: "#dcf0f7", width: 0.03 },
  ];
};

const crops: Drawing = (width, depth) => [
  { d: rect(0, 0, width, depth, 0.06), fill: "#e5d6b4" },
  { d: stripes(width, depth, 0.22, true), line: "#b9d38f", width: 0.09 },
];

/** Round spots, spread evenly and always alike. */
function spots(width: number, depth: number, every: number, radius: number): string {
  const [columns, rows] = [Math.floor(width / every), Math.floor(depth / every)];
  return Array.from({ length: columns * rows }, (_, index) => {
    const [column, row] = [index % columns, Math.floor(index / columns)];
    const swing = 0.2 * every * (index % 2 === 0 ? 1 : -1);
    const x = -width / 2 + ((column + 0.5) * width) / columns + swing;
    const y = -depth / 2 + ((row + 0.5) * depth) / rows + 0.5 * swing;
    return oval(x, y, radius);
  }).join("");
}

const nothing: Drawing = () => [];

/**
 * The layers of each print, lowest first. Where streets cross, all pavements lie below all asphalt,
 * and all asphalt below all lines.
 */
const LAYERS: Readonly<Record<PrintKind, readonly [Drawing, Drawing, Drawing]>> = {
  street: [pavement, asphalt, dashes],
  garden: [nothing, garden, nothing],
  pond: [nothing, pond, nothing],
  rug: [nothing, rug, nothing],
  crops: [nothing, crops, nothing],
  crossing: [nothing, nothing, crossing],
  roof: [nothing, nothing, roof],
};

/** The colour of prints that can have any, where a world gives none. */
const DEFAULT_COLOURS: Partial<Record<PrintKind, string>> = { roof: "#c2603f", rug: "#b5493c" };

export const hasColour = (kind: PrintKind): boolean => kind in DEFAULT_COLOURS;

/** The parts of all prints of a floor, lowest first, each with its print. */
export function printedParts(prints: readonly Printed[]): { print: Printed; part: Part }[] {
  return [0, 1, 2].flatMap((layer) =>
    prints.flatMap((print) => {
      const [width = 0, depth = 0] = print.size;
      const colour = print.color ? paintOf(print.color) : (DEFAULT_COLOURS[print.kind] ?? "");
      const parts = LAYERS[print.kind][layer]?.(width, depth, colour) ?? [];
      return parts.map((part) => ({ print, part }));
    }),
  );
}
