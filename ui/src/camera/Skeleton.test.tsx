import { act, cleanup, render, screen } from "@testing-library/preact";
import { afterEach, beforeEach, expect, test } from "vitest";
import { Skeleton } from "./Skeleton";
import { receive } from "./sight";
import { changed, hand, sightOf } from "./testing/camera_events";

beforeEach(() => receive(changed("on")));
afterEach(() => {
  cleanup();
  receive(changed("off"));
});

test("a hand with landmarks is drawn as a skeleton, without a box", () => {
  const { container } = render(<Skeleton />);
  act(() => receive(sightOf(hand())));
  expect(container.querySelectorAll("path").length).toBeGreaterThan(0);
  expect(container.querySelector("rect")).toBeNull();
});

test("a sign of a detector is a box with its name, and a doubted one has a question mark", () => {
  const { container } = render(<Skeleton />);
  const box = [0.25, 0.5, 0.75, 0.9];
  act(() =>
    receive(sightOf(hand({ points: [], box }), hand({ points: [], box, best: "F", sure: false }))),
  );
  expect(screen.getByText("B")).toBeTruthy();
  expect(screen.getByText("F ?")).toBeTruthy();
  const [frame] = container.querySelectorAll("rect");
  // the picture is 4 : 3 and 100 high
  expect(Number(frame?.getAttribute("x"))).toBeCloseTo(33.3, 1);
  expect(Number(frame?.getAttribute("y"))).toBeCloseTo(50);
  expect(Number(frame?.getAttribute("width"))).toBeCloseTo(66.7, 1);
  expect(Number(frame?.getAttribute("height"))).toBeCloseTo(40);
});
