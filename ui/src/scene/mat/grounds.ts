import type { World } from "../../api/model";
import { oval, type Part, rect, stripes } from "./parts";

export type Ground = NonNullable<World["ground"]>;
type DrawGround = (width: number, depth: number) => Part[];

const town: DrawGround = (width, depth) => [
  { d: rect(0, 0, width, depth), fill: "#dfeecf" },
  {
    d: scattered(width, depth, (x, y) => `M${x} ${y}l0.03 0.08l0.03 -0.05l0.03 0.06`),
    line: "#bcd8a5",
    width: 0.018,
  },
];

const livingRoom: DrawGround = (width, depth) => [
  { d: rect(0, 0, width, depth), fill: "#f3e7d3" },
  { d: planks(width, depth), line: "#e3d2b6", width: 0.015 },
];

const classroom: DrawGround = (width, depth) => [
  { d: rect(0, 0, width, depth), fill: "#eef2ef" },
  { d: stripes(width, depth, 0.5, true), line: "#dde5e0", width: 0.02 },
  { d: stripes(width, depth, 0.5, false), line: "#dde5e0", width: 0.02 },
];

const court: DrawGround = (width, depth) => {
  const [long, wide] = [width - 0.3, depth - 0.3];
  const middle = width >= depth ? `M0 ${-wide / 2}V${wide / 2}` : `M${-long / 2} 0H${long / 2}`;
  const circle = oval(0, 0, 0.22 * Math.min(long, wide));
  return [
    { d: rect(0, 0, width, depth), fill: "#f1dcc3" },
    { d: rect(0, 0, long, wide) + middle + circle, line: "#ffffff", width: 0.05 },
  ];
};

const sea: DrawGround = (width, depth) => [
  { d: rect(0, 0, width, depth), fill: "#d6ebf4" },
  {
    d: scattered(width, depth, (x, y) => `M${x} ${y}q0.08 0.07 0.16 0q0.08 -0.07 0.16 0`),
    line: "#b3d8e8",
    width: 0.022,
  },
];

const farm: DrawGround = (width, depth) => [
  { d: rect(0, 0, width, depth), fill: "#e9edcb" },
  {
    d: scattered(width, depth, (x, y) => `M${x} ${y}l0 0.09M${x} ${y}l0.05 0.07`),
    line: "#cbd4a0",
    width: 0.02,
  },
];

/** What covers the floor, without anything that stands out more than the robot, its path and the goal. */
export const GROUNDS: Readonly<Record<Ground, DrawGround>> = {
  town,
  living_room: livingRoom,
  classroom,
  court,
  sea,
  farm,
};

const EVERY_M = 0.8;

/** A small motif all over the floor, unevenly but always alike. */
function scattered(width: number, depth: number, motif: (x: number, y: number) => string): string {
  const [columns, rows] = [Math.floor(width / EVERY_M), Math.floor(depth / EVERY_M)];
  return Array.from({ length: columns * rows }, (_, index) => {
    const [column, row] = [index % columns, Math.floor(index / columns)];
    const swing = (seed: number) => (((index * seed) % 11) / 11 - 0.5) * 0.7 * EVERY_M;
    const x = -width / 2 + (column + 0.5) * EVERY_M + swing(7);
    const y = -depth / 2 + (row + 0.5) * EVERY_M + swing(5);
    return motif(x, y);
  }).join("");
}

const PLANK_M = 0.25;
const PLANK_LENGTH_M = 1.6;

function planks(width: number, depth: number): string {
  const rows = Math.ceil(depth / PLANK_M);
  const ends = Array.from({ length: rows }, (_, row) => {
    const [from, to] = [
      -depth / 2 + row * PLANK_M,
      Math.min(depth / 2, -depth / 2 + (row + 1) * PLANK_M),
    ];
    const first = -width / 2 + ((row * 0.37) % 1) * PLANK_LENGTH_M;
    const n = Math.max(0, Math.ceil((width / 2 - first) / PLANK_LENGTH_M));
    return Array.from({ length: n }, (_, i) => `M${first + i * PLANK_LENGTH_M} ${from}V${to}`).join(
      "",
    );
  });
  const seams = Array.from({ length: rows - 1 }, (_, i) => {
    const y = -depth / 2 + (i + 1) * PLANK_M;
    return `M${-width / 2} ${y}H${width / 2}`;
  });
  return [...seams, ...ends].join("");
}
