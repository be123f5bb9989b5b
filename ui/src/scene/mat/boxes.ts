import type { World } from "../../api/model";
import { type Drawing, oval, type Part, rect, stripes } from "./parts";

export type BoxKind = NonNullable<World["boxes"][number]["kind"]>;

const EDGE_M = 0.03;

/** A body that fills its size, with the edge inside. */
function body(width: number, depth: number, fill: string, line: string, radius = 0.04): Part {
  const edge = Math.min(EDGE_M, width / 4, depth / 4);
  return { d: rect(0, 0, width - edge, depth - edge, radius), fill, line, width: edge };
}

const crate: Drawing = (width, depth) => {
  const [right, top] = [width / 2 - 0.12 * width, depth / 2 - 0.12 * depth];
  return [
    body(width, depth, "#d9b073", "#94703a"),
    { d: rect(0, 0, 2 * right, 2 * top), line: "#b98f52", width: 0.04 * Math.min(width, depth) },
    {
      d: `M${-right} ${-top}L${right} ${top}M${-right} ${top}L${right} ${-top}`,
      line: "#b98f52",
      width: Math.min(0.07, 0.14 * Math.min(width, depth)),
    },
  ];
};

const table: Drawing = (width, depth) => [
  body(width, depth, "#c99a68", "#7c5630", 0.06),
  { d: stripes(0.88 * width, 0.88 * depth, 0.16, true), line: "#b38453", width: 0.015 },
];

const chair: Drawing = (width, depth) => [
  body(width, depth, "#5d92d6", "#2f5c97", 0.08),
  { d: rect(0, 0.4 * depth, width, 0.2 * depth, 0.05), fill: "#386aa9" },
];

const bed: Drawing = (width, depth) => {
  const isLong = depth >= width;
  const [along, across] = isLong ? [depth, width] : [width, depth];
  // the head is up, or left
  const at = (from: number, length: number, wide: number, radius: number) => {
    const middle = along / 2 - (from + length / 2) * along;
    return isLong
      ? rect(0, middle, wide * across, length * along, radius)
      : rect(-middle, 0, length * along, wide * across, radius);
  };
  return [
    body(width, depth, "#b98a5e", "#7c5630"),
    { d: at(0.04, 0.92, 0.9, 0.05), fill: "#f7f3ea" },
    { d: at(0.07, 0.16, 0.6, 0.06), fill: "#e9e2d2" },
    { d: at(0.32, 0.64, 0.9, 0.05), fill: "#7fb0dd" },
    { d: at(0.32, 0.1, 0.9, 0.04), fill: "#a9cdec" },
  ];
};

const LEAVES = 8;

const plant: Drawing = (width, depth) => {
  const r = Math.min(width, depth) / 2;
  const leaf = (index: number) => {
    const angle = (index * 2 * Math.PI) / LEAVES;
    const [x, y] = [0.45 * r * Math.cos(angle), 0.45 * r * Math.sin(angle)];
    return oval(x, y, 0.3 * r);
  };
  return [
    body(width, depth, "#cd7350", "#8f4428", 0.1 * r),
    { d: oval(0, 0, 0.78 * r), fill: "#6b4630" },
    { d: Array.from({ length: LEAVES }, (_, i) => leaf(i)).join(""), fill: "#5fa457" },
    { d: oval(0, 0, 0.34 * r), fill: "#86c473" },
  ];
};

const cone: Drawing = (width, depth) => {
  const r = Math.min(width, depth) / 2;
  return [
    body(width, depth, "#c94a17", "#8c2f0b", 0.3 * r),
    { d: oval(0, 0, 0.74 * r), fill: "#f26a21" },
    { d: oval(0, 0, 0.5 * r), fill: "#ffffff" },
    { d: oval(0, 0, 0.28 * r), fill: "#f26a21" },
  ];
};

const fence: Drawing = (width, depth) => {
  const isWide = width >= depth;
  const [along, across] = isWide ? [width, depth] : [depth, width];
  const n = Math.max(2, Math.round(along / 0.3) + 1);
  const post = (index: number) => {
    const at = 0.88 * along * (index / (n - 1) - 0.5);
    const [thick, long] = [Math.min(0.07, 0.06 * along), 0.9 * across];
    return isWide ? rect(at, 0, thick, long, 0.02) : rect(0, at, long, thick, 0.02);
  };
  return [
    body(width, depth, "#e8d3a8", "#a88b58", 0.02),
    {
      d: stripes(0.96 * width, 0.96 * depth, across / 3, true),
      line: "#c4a774",
      width: 0.04 * across,
    },
    {
      d: Array.from({ length: n }, (_, i) => post(i)).join(""),
      fill: "#f6e7c6",
      line: "#a88b58",
      width: 0.04 * across,
    },
  ];
};

const tree: Drawing = (width, depth) => {
  const [rx, ry] = [width / 2, depth / 2];
  return [
    body(width, depth, "#8d6f4c", "#5f4830", 0.05),
    { d: oval(0, 0, 0.97 * rx, 0.97 * ry), fill: "#5c9f52" },
    { d: oval(-0.15 * rx, 0.18 * ry, 0.66 * rx, 0.66 * ry), fill: "#74b766" },
    { d: oval(-0.32 * rx, 0.36 * ry, 0.26 * rx, 0.26 * ry), fill: "#a3d693" },
  ];
};

const bin: Drawing = (width, depth) => {
  const r = Math.min(width, depth) / 2;
  return [
    body(width, depth, "#9fa3a0", "#5f6461", 0.3 * r),
    { d: oval(0, 0, 0.72 * r), fill: "#c3c8c4", line: "#7c827e", width: 0.06 * r },
    { d: oval(0, 0, 0.36 * r), fill: "#6a706c" },
  ];
};

export const BOOKS = ["#b5493c", "#3f78b8", "#5b9a55", "#e0b13c", "#7d58a8"];

const bookshelf: Drawing = (width, depth) => {
  const isWide = width >= depth;
  const [along, across] = isWide ? [width, depth] : [depth, width];
  const n = Math.max(3, Math.round(along / 0.12));
  const step = (0.92 * along) / n;
  const book = (index: number) => {
    const at = -0.46 * along + (index + 0.5) * step;
    const long = across * (index % 3 === 1 ? 0.56 : 0.68);
    return isWide ? rect(at, 0, 0.8 * step, long) : rect(0, at, long, 0.8 * step);
  };
  const books = BOOKS.map((fill, colour) => ({
    d: Array.from({ length: n }, (_, i) => (i % BOOKS.length === colour ? book(i) : "")).join(""),
    fill,
  }));
  return [body(width, depth, "#a8794c", "#694525"), ...books];
};

/** A building that stands in the way. */
const house: Drawing = (width, depth) => {
  const chimney = Math.min(0.3, 0.2 * Math.min(width, depth));
  return [
    body(width, depth, "#c9694a", "#85402a", 0.05),
    { d: stripes(0.96 * width, 0.96 * depth, 0.22, true), line: "#b3583b", width: 0.02 },
    ridge(0.96 * width, 0.96 * depth, "#f3d8cb"),
    {
      d: rect(width / 4, depth / 4, chimney, chimney, 0.02),
      fill: "#7a6a5f",
      line: "#4d423a",
      width: 0.1 * chimney,
    },
  ];
};

/** The highest line of a roof. */
export const ridge = (width: number, depth: number, line: string): Part => ({
  d: width >= depth ? `M${-width / 2} 0H${width / 2}` : `M0 ${-depth / 2}V${depth / 2}`,
  line,
  width: Math.min(0.04, 0.04 * Math.max(width, depth)),
});

/** Drawings of the things that a robot cannot pass. */
export const BOX_DRAWINGS: Readonly<Record<BoxKind, Drawing>> = {
  crate,
  table,
  chair,
  bed,
  plant,
  cone,
  fence,
  tree,
  bin,
  bookshelf,
  house,
};
