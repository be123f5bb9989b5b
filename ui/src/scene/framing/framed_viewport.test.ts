import { expect, test } from "vitest";
import { IDLE } from "../../run/reducer";
import { type Framed, FramedViewport, type Framing } from "./framed_viewport";
import { marginsOf } from "./viewport";

const FRAMED: Framed = {
  world: null,
  whole: IDLE,
  companion: null,
  bundle: null,
  size: { width: 600, height: 400 },
  magnification: 1,
  hasControls: false,
};
const ROBOT = { x: 1, y: 2 };

function framed(): { viewport: FramedViewport; framings: Framing[] } {
  const framings: Framing[] = [];
  const viewport = new FramedViewport(
    () => FRAMED,
    (framing) => framings.push(framing),
  );
  viewport.reset();
  return { viewport, framings };
}

test("fitting shows the whole room and then the subject again", () => {
  const { viewport, framings } = framed();
  viewport.fit();
  viewport.fit();
  expect(framings).toEqual(["room", "subject"]);
});

test("a pan is the user's view, and moves the floor under the pointer", () => {
  const { viewport, framings } = framed();
  viewport.advance(ROBOT, 50, true);
  const before = viewport.floorAt({ x: 300, y: 200 });
  viewport.pan(viewport.current.scale, 0);
  expect(framings).toEqual(["manual"]);
  expect(viewport.floorAt({ x: 300, y: 200 }).x).toBeCloseTo(before.x - 1);
});

test("a viewport that follows the robot goes to it, except while something is dragged", () => {
  const { viewport } = framed();
  viewport.follow(true);
  viewport.advance(ROBOT, 50, true);
  expect(viewport.current).toMatchObject(ROBOT);
  viewport.hold(true);
  viewport.advance({ x: 3, y: 3 }, 50, true);
  expect(viewport.current).toMatchObject(ROBOT);
});

test("a low floor leaves the room of its tools, which are side by side", () => {
  const rightOf = (height: number) => marginsOf({ width: 314, height }, 1, false).right;
  expect([rightOf(400), rightOf(218)]).toEqual([66, 110]);
});
