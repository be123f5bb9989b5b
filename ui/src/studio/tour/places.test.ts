import { expect, test } from "vitest";
import { placeBeside, shared } from "./places";

const window = { width: 1366, height: 768 };
const size = { width: 300, height: 140 };

test("a balloon stands below what it is about", () => {
  const beside = { x: 400, y: 100, width: 200, height: 50 };
  expect(placeBeside({ size, beside, free: [beside], window })).toEqual({ x: 400, y: 162 });
});

test("it stands at the left of what reaches to the lower edge", () => {
  const beside = { x: 800, y: 200, width: 550, height: 560 };
  expect(placeBeside({ size, beside, free: [beside], window })).toEqual({ x: 488, y: 410 });
});

test("it covers nothing that is needed", () => {
  const beside = { x: 400, y: 100, width: 200, height: 50 };
  const below = { x: 450, y: 200, width: 50, height: 50 };
  expect(placeBeside({ size, beside, free: [beside, below], window })).toEqual({ x: 88, y: 55 });
});

test("it stays in the window where there is no place for it", () => {
  const beside = { x: 0, y: 0, width: 1366, height: 768 };
  expect(placeBeside({ size, beside, free: [beside], window })).toEqual({ x: 12, y: 616 });
});

test("of a block only the part that is seen has a ring", () => {
  const block = { x: 400, y: 100, width: 300, height: 50 };
  const pane = { x: 0, y: 64, width: 600, height: 700 };
  expect(shared(block, pane)).toEqual({ x: 400, y: 100, width: 200, height: 50 });
  expect(shared(block, { ...pane, width: 400 })).toBeNull();
});
