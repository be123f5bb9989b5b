import { render } from "@testing-library/preact";
import { expect, test } from "vitest";
import { PathPicture } from "./PathPicture";

const PATH = [
  [0, 0],
  [1, 0],
];

const shapesOf = (failed: boolean) => {
  const { container } = render(<PathPicture path={PATH} failed={failed} />);
  return [".path-picture__robot", ".path-picture__failed"].map(
    (one) => container.querySelectorAll(one).length,
  );
};

test("a run that stopped before its end has another sign at its end than one that did not", () => {
  expect(shapesOf(false)).toEqual([1, 0]);
  expect(shapesOf(true)).toEqual([0, 1]);
});
