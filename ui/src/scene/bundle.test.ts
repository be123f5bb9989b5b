import { expect, test } from "vitest";
import { type Bundle, pathAt } from "./bundle";

const bundle: Bundle = {
  isFaint: false,
  paths: [
    {
      id: 1,
      well: true,
      path: [
        [0, 0],
        [2, 0],
      ],
    },
    {
      id: 2,
      well: false,
      path: [
        [0, 0],
        [1, 0.1],
      ],
    },
    { id: 3, well: false, path: [] },
  ],
};

test("a click near an end means the robot that ended there, even on the path of another", () => {
  expect(pathAt(bundle, { x: 1, y: 0.05 }, 0.08)?.id).toBe(2);
  expect(pathAt(bundle, { x: 2.02, y: 0 }, 0.08)?.id).toBe(1);
});

test("else the nearest path counts, between its points too", () => {
  expect(pathAt(bundle, { x: 1.5, y: 0.02 }, 0.08)?.id).toBe(1);
  expect(pathAt(bundle, { x: 0.6, y: 0.07 }, 0.08)?.id).toBe(2);
});

test("far from all paths there is none", () => {
  expect(pathAt(bundle, { x: 1, y: 1 }, 0.08)).toBeNull();
});
