import { BOOKS, type BoxKind } from "./boxes";
import { mixed } from "./parts";

/**
 * One body of a form: metres, x right, y up as in the drawing from above, z the height over the floor. `size` is that of
 * the box around it, `at` the middle of its base. `top` is the size of its upper end as a part of the lower one.
 */
export interface Solid {
  readonly form: "block" | "round" | "ball" | "roof";
  readonly at: readonly [x: number, y: number, z: number];
  readonly size: readonly [width: number, depth: number, height: number];
  readonly fill: string;
  readonly top?: number;
}

/** The bodies of something of a size in metres. They fill the size exactly, as the drawing from above does. */
export type Bodies = (width: number, depth: number) => Solid[];

type Triple = readonly [number, number, number];

const block = (at: Triple, size: Triple, fill: string, top = 1): Solid => ({
  form: "block",
  at,
  size,
  fill,
  top,
});
const round = (at: Triple, size: Triple, fill: string, top = 1): Solid => ({
  form: "round",
  at,
  size,
  fill,
  top,
});
const ball = (at: Triple, size: Triple, fill: string): Solid => ({ form: "ball", at, size, fill });

/** Turns bodies that were written with the longer side along x. */
function alongLonger(bodies: Bodies): Bodies {
  return (width, depth) => {
    if (width >= depth) return bodies(width, depth);
    return bodies(depth, width).map((solid) => ({
      ...solid,
      at: [-solid.at[1], solid.at[0], solid.at[2]],
      size: [solid.size[1], solid.size[0], solid.size[2]],
    }));
  };
}

const CORNERS = [
  [-1, -1],
  [1, -1],
  [1, 1],
  [-1, 1],
] as const;

/** Four bars around a rectangle of a size, the outer edge on its sides. */
function frame(
  width: number,
  depth: number,
  bar: number,
  [z, height]: readonly [number, number],
  fill: string,
): Solid[] {
  const [x, y] = [(width - bar) / 2, (depth - bar) / 2];
  return [
    block([0, -y, z], [width, bar, height], fill),
    block([0, y, z], [width, bar, height], fill),
    block([-x, 0, z], [bar, depth - 2 * bar, height], fill),
    block([x, 0, z], [bar, depth - 2 * bar, height], fill),
  ];
}

/** A crate in the colours of its planks and of its frame. */
export const crateOf =
  (plank: string, bars: string): Bodies =>
  (width, depth) => {
    const height = Math.min(0.42, Math.max(0.12, 0.85 * Math.min(width, depth)));
    const bar = Math.min(0.07, 0.16 * Math.min(width, depth));
    const posts = CORNERS.map(([x, y]) =>
      block([(x * (width - bar)) / 2, (y * (depth - bar)) / 2, 0], [bar, bar, height], bars),
    );
    const inset = 0.45 * bar;
    return [
      block([0, 0, 0], [width - 2 * inset, depth - 2 * inset, height - inset], plank),
      ...frame(width, depth, bar, [0, bar], bars),
      ...frame(width, depth, bar, [height - bar, bar], bars),
      ...posts,
    ];
  };

/** A plain box: a chest with a lid that stands out from its sides. */
export const chestOf =
  (fill: string, edge: string): Bodies =>
  (width, depth) => {
    const [height, lid] = [0.34, 0.05];
    return [
      block([0, 0, 0], [0.97 * width, 0.97 * depth, height - lid], edge),
      block([0, 0, height - lid], [width, depth, lid], fill),
    ];
  };

const TABLE_M = 0.42;

/** The sides are closed: the sonar sees no legs, and the robot does not pass below. */
const table: Bodies = (width, depth) => {
  const leg = Math.min(0.08, 0.2 * Math.min(width, depth));
  const legs = CORNERS.map(([x, y]) =>
    block(
      [(x * (0.96 * width - leg)) / 2, (y * (0.96 * depth - leg)) / 2, 0],
      [leg, leg, TABLE_M - 0.05],
      "#8f6438",
    ),
  );
  return [
    block([0, 0, 0], [0.9 * width, 0.9 * depth, TABLE_M - 0.05], "#b38453"),
    ...legs,
    block([0, 0, TABLE_M - 0.05], [width, depth, 0.05], "#d3a572"),
  ];
};

const chair: Bodies = (width, depth) => [
  block([0, 0, 0], [0.9 * width, 0.9 * depth, 0.2], "#477fc4"),
  block([0, 0, 0.2], [width, depth, 0.06], "#5d92d6"),
  block([0, 0.41 * depth, 0.26], [width, 0.18 * depth, 0.26], "#386aa9"),
];

/** The head is up, or left. */
const bed: Bodies = (width, depth) => {
  const isLong = depth >= width;
  const [along, across] = isLong ? [depth, width] : [width, depth];
  const part = (
    from: number,
    length: number,
    wide: number,
    [z, height]: readonly [number, number],
    fill: string,
  ) => {
    const middle = along / 2 - (from + length / 2) * along;
    return isLong
      ? block([0, middle, z], [wide * across, length * along, height], fill)
      : block([-middle, 0, z], [length * along, wide * across, height], fill);
  };
  return [
    part(0, 1, 1, [0, 0.14], "#b98a5e"),
    part(0, 0.04, 1, [0.14, 0.26], "#9c7048"),
    part(0.04, 0.93, 0.94, [0.14, 0.1], "#f7f3ea"),
    part(0.08, 0.15, 0.66, [0.24, 0.06], "#ffffff"),
    part(0.34, 0.63, 0.96, [0.2, 0.06], "#7fb0dd"),
    part(0.32, 0.1, 0.97, [0.21, 0.06], "#a9cdec"),
  ];
};

const plant: Bodies = (width, depth) => {
  const r = Math.min(width, depth) / 2;
  const leaf = (index: number) => {
    const angle = (index * 2 * Math.PI) / 5;
    const at = [0.42 * r * Math.cos(angle), 0.42 * r * Math.sin(angle), 0.26] as const;
    return ball(at, [1.05 * r, 1.05 * r, 0.2], index % 2 ? "#5fa457" : "#6fb364");
  };
  return [
    block([0, 0, 0], [0.78 * width, 0.78 * depth, 0.2], "#b9603e", 1.2),
    block([0, 0, 0.2], [width, depth, 0.06], "#cd7350"),
    block([0, 0, 0.26], [0.84 * width, 0.84 * depth, 0.01], "#6b4630"),
    ...[0, 1, 2, 3, 4].map(leaf),
    ball([0, 0, 0.34], [0.95 * r, 0.95 * r, 0.2], "#86c473"),
  ];
};

const cone: Bodies = (width, depth) => {
  const r = Math.min(width, depth) / 2;
  const part = (from: number, to: number, z: number, height: number, fill: string) =>
    round([0, 0, z], [2 * from * r, 2 * from * r, height], fill, to / from);
  return [
    block([0, 0, 0], [width, depth, 0.03], "#c94a17"),
    part(0.78, 0.58, 0.03, 0.1, "#f26a21"),
    part(0.58, 0.4, 0.13, 0.09, "#ffffff"),
    part(0.4, 0.24, 0.22, 0.08, "#f26a21"),
    part(0.24, 0.14, 0.3, 0.05, "#ffffff"),
  ];
};

const fence: Bodies = alongLonger((width, depth) => {
  const n = Math.max(2, Math.round(width / 0.22));
  const step = width / n;
  const picket = (index: number) => {
    const x = -width / 2 + (index + 0.5) * step;
    const size = [0.62 * step, 0.9 * depth, 0.34] as const;
    return [
      block([x, 0, 0], size, "#f6e7c6"),
      { ...block([x, 0, 0.34], [size[0], size[1], 0.07], "#f6e7c6"), form: "roof" as const },
    ];
  };
  return [
    block([0, 0, 0], [width, depth, 0.04], "#c4a774"),
    block([0, 0, 0.04], [0.99 * width, 0.45 * depth, 0.24], "#d9c191"),
    ...Array.from({ length: n }, (_, index) => picket(index)).flat(),
  ];
});

const tree: Bodies = (width, depth) => {
  const trunk = 0.22 * Math.min(width, depth);
  return [
    block([0, 0, 0], [width, depth, 0.07], "#8d6f4c"),
    block([0, 0, 0.07], [0.86 * width, 0.86 * depth, 0.01], "#7fae63"),
    round([0, 0, 0.07], [trunk, trunk, 0.34], "#7a5a3a", 0.8),
    ball([0, 0, 0.3], [0.98 * width, 0.98 * depth, 0.46], "#5c9f52"),
    ball([-0.1 * width, 0.1 * depth, 0.46], [0.7 * width, 0.7 * depth, 0.4], "#74b766"),
  ];
};

const bin: Bodies = (width, depth) => [
  block([0, 0, 0], [0.8 * width, 0.8 * depth, 0.34], "#8b918d", 1.18),
  block([0, 0, 0.34], [width, depth, 0.05], "#c3c8c4"),
  block([0, 0, 0.39], [0.5 * width, 0.5 * depth, 0.02], "#6a706c"),
];

const BOOKSHELF_M = 0.56;

const bookshelf: Bodies = alongLonger((width, depth) => {
  const board = Math.min(0.03, 0.1 * width);
  const inner = width - 2 * board;
  const n = Math.max(3, Math.round(inner / 0.09));
  const step = inner / n;
  const rows = [board, (BOOKSHELF_M + board) / 2];
  const height = (BOOKSHELF_M - 3 * board) / 2;
  const book = (index: number, row: number) => {
    const x = -inner / 2 + (index + 0.5) * step;
    const tall = height * (0.72 + 0.07 * ((index * 3 + row) % 4));
    const fill = BOOKS[(index + 2 * row) % BOOKS.length] ?? "";
    return block([x, 0, rows[row] ?? 0], [0.86 * step, 0.94 * depth, tall], fill);
  };
  const boards = [0, (BOOKSHELF_M - board) / 2, BOOKSHELF_M - board];
  const sides = [-1, 1].map((side) => (side * (width - board)) / 2);
  return [
    block([0, 0, board], [inner, 0.7 * depth, BOOKSHELF_M - 2 * board], "#8a6039"),
    ...boards.map((z) => block([0, 0, z], [inner, depth, board], "#a8794c")),
    ...sides.map((x) => block([x, 0, 0], [board, depth, BOOKSHELF_M], "#a8794c")),
    ...[0, 1].flatMap((row) => Array.from({ length: n }, (_, index) => book(index, row))),
  ];
});

const house: Bodies = (width, depth) => {
  const wall = 0.44;
  const [w, d] = [0.93 * width, 0.93 * depth];
  const side = Math.min(width, depth);
  const roof = Math.min(0.5, 0.34 * side);
  const pane = Math.min(0.22, 0.2 * side);
  const chimney = Math.min(0.3, 0.2 * side);
  const windows = [-0.28, 0.28].flatMap((x) => [-1, 1].map((y) => [x, y] as const));
  return [
    block([0, 0, 0], [w, d, wall], "#f3e3cd"),
    block([0, 0, 0], [1.01 * w, 1.01 * d, 0.05], "#cbb79a"),
    ...windows.map(([x, y]) =>
      block([x * w, (y * 0.99 * d) / 2, 0.16], [pane, 0.03 * d, 0.17], "#8fc0d8"),
    ),
    block([0, -0.49 * d, 0], [0.8 * pane, 0.045 * d, 0.28], "#8a4a35"),
    block([width / 4, depth / 4, wall], [chimney, chimney, roof + 0.04], "#7a6a5f"),
    { form: "roof", at: [0, 0, wall], size: [width, depth, roof], fill: "#c9694a" },
  ];
};

/** The forms of the things that a robot cannot pass, beside their drawings from above (`BOX_DRAWINGS`). */
export const BOX_SOLIDS: Readonly<Record<BoxKind, Bodies>> = {
  crate: crateOf("#d9b073", "#b0844a"),
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

/** A wall: its height is for the eye, since no sensor sees over it. */
export const WALL_HEIGHT_M = 0.35;

export const wallOf =
  (fill: string): Bodies =>
  (width, depth) => [
    block([0, 0, 0], [width, depth, WALL_HEIGHT_M], fill),
    block([0, 0, WALL_HEIGHT_M], [width, depth, 0.012], mixed(fill, "#ffffff", 0.28)),
  ];
