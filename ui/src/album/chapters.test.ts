import { expect, test } from "vitest";
import type { Sticker } from "../api/model";
import { chaptersOf, onPaper, printLayout } from "./chapters";

const sticker = (name: string, more: Partial<Sticker> = {}): Sticker => ({
  name,
  kind: "mission",
  path: "moves",
  title: name,
  win: null,
  n_done: 0,
  n_needed: 1,
  ...more,
});
const own = (n: number, won: number) =>
  Array.from({ length: n }, (_, index) =>
    sticker(`own ${index}`, {
      kind: "own",
      path: null,
      win: index < won ? { won_at: "2026-11-12T13:00:00Z", run_id: "r" } : null,
    }),
  );
const SHIPPED = [6, 7, 7, 6, 2, 4];

test("chapters follow the paths, with the activities of teachers and character at the end", () => {
  const chapters = chaptersOf([
    sticker("repair", { kind: "character", path: null }),
    ...own(1, 0),
    sticker("maze", { path: "sensors" }),
    sticker("square", { path: "shapes" }),
    sticker("from the moon", { path: "moon" }),
  ]);
  expect(chapters.map(({ name, stickers }) => [name, stickers.length])).toEqual([
    ["shapes", 1],
    ["sensors", 1],
    ["own", 2],
    ["character", 1],
  ]);
});

test("the shipped album has one row a chapter on paper, with a sentence for each place", () => {
  const { columns, side, withNotes } = printLayout(SHIPPED);
  expect([columns, withNotes]).toEqual([7, true]);
  expect(side).toBeGreaterThan(16);
});

test.each([0, 1, 7, 14, 30, 60, 100])("with %i activities of teachers it fits on one page", (n) => {
  const sizes = n ? [...SHIPPED, n] : SHIPPED;
  const { columns, side, withNotes } = printLayout(sizes);
  const nRows = sizes.reduce((sum, size) => sum + Math.ceil(size / columns), 0);
  const texts = withNotes ? 16 : 7;
  expect(nRows * (side + texts + 2) + sizes.length * 7).toBeLessThanOrEqual(256.5);
  expect(columns * (side + 2)).toBeLessThanOrEqual(190.5);
});

test("empty places of many activities of teachers are not printed, their stickers are", () => {
  const [few] = chaptersOf(own(14, 1));
  const [many] = chaptersOf(own(60, 3));
  expect(few && onPaper(few)).toHaveLength(14);
  expect(many && onPaper(many)).toHaveLength(3);
});
