import { expect, test } from "vitest";
import { columnsOf } from "./columns";

const AREA = { width: 400, height: 600, maxScale: 1, minScale: 0.5 };

const stackOf = (count: number, width = 200, height = 50) =>
  Array.from({ length: count }, (_, number) => ({ width, height, number }));

test("a short program is one column at the largest scale", () => {
  const { placed, scale, height } = columnsOf([stackOf(3)], AREA);
  expect(scale).toBe(1);
  expect(placed.map(({ x, y }) => [x, y])).toEqual([
    [0, 0],
    [0, 50],
    [0, 100],
  ]);
  expect(height).toBe(150);
});

test("stacks have a gap between them", () => {
  const { placed } = columnsOf([stackOf(1), stackOf(1)], AREA);
  expect(placed[1]?.y).toBeGreaterThan(50);
});

test("a longer program becomes smaller, and continues in further columns before it becomes too small", () => {
  const { placed, scale, height } = columnsOf([stackOf(30)], AREA);
  expect(scale).toBeGreaterThan(AREA.minScale);
  expect(new Set(placed.map(({ x }) => x)).size).toBe(2);
  expect(height).toBeLessThanOrEqual(AREA.height);
});

test.each([60, 200])("no block of a program of %i blocks is cut or left out", (count) => {
  const { placed, scale, height } = columnsOf([stackOf(count)], AREA);
  expect(placed.map(({ block }) => block.number)).toEqual(
    stackOf(count).map(({ number }) => number),
  );
  expect(scale).toBeGreaterThanOrEqual(AREA.minScale);
  for (const { block, x, y } of placed) {
    expect(x + block.width * scale).toBeLessThanOrEqual(AREA.width + 1);
    expect(y + block.height * scale).toBeLessThanOrEqual(height + 1e-6);
  }
  const corners = new Set(placed.map(({ x, y }) => `${x} ${y}`));
  expect(corners.size).toBe(count);
});

test("a loop that is higher than the area stays whole", () => {
  const loop = { width: 200, height: 3000, number: 0 };
  const { height, scale } = columnsOf([[...stackOf(1), loop]], AREA);
  expect(height).toBeGreaterThanOrEqual(3000 * scale);
});

test("a block that is wider than the area becomes as small as it must be", () => {
  const { scale } = columnsOf([stackOf(2, 1600)], AREA);
  expect(1600 * scale).toBeLessThanOrEqual(AREA.width);
});

test("without blocks nothing is placed", () => {
  expect(columnsOf([], AREA).placed).toEqual([]);
});
