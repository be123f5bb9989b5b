import { describe, expect, test } from "vitest";
import { textsOf } from "../../i18n";
import { BoxInterpolator } from "../box_interpolator";
import { toFloor, toScreen } from "../framing/viewport";
import { measured, snapped, turnBetween, turned } from "./measure";
import { measureText } from "./measure_view";
import { facing, handleOf, movedTo, nudged } from "./start_pose";
import { SceneTools } from "./tools";

const START = { x_m: 0, y_m: 0, heading_deg: 0 };
const at = (x: number, y: number) => ({ x, y });

describe("the ruler", () => {
  test("tells the distance of its ends, and nothing with one", () => {
    expect(measured("ruler", [at(0, 0)])).toBeNull();
    expect(measured("ruler", [at(-1, 0), at(2, 4)])).toEqual({ kind: "distance", metres: 5 });
  });

  test("is laid to what is near, and only to that", () => {
    expect(snapped(at(0.95, 0.02), [at(0, 0), at(1, 0)], 0.2)).toEqual(at(1, 0));
    expect(snapped(at(0.5, 0), [at(0, 0), at(1, 0)], 0.2)).toEqual(at(0.5, 0));
  });
});

describe("the protractor", () => {
  test("counts turns to the left, as the block does", () => {
    expect(turnBetween(at(1, 1), at(2, 1), at(1, 3))).toBeCloseTo(90);
    expect(turnBetween(at(0, 0), at(0, 1), at(1, 1))).toBeCloseTo(-45);
    expect(turnBetween(at(0, 0), at(1, 0), at(-1, -0))).toBe(180);
  });

  test("says the side in words", () => {
    const angleText = (degrees: number) =>
      measureText({ kind: "angle", degrees }, textsOf("pt-BR"), "pt-BR");
    expect(angleText(90)).toBe("90° à esquerda");
    expect(angleText(-44.6)).toBe("45° à direita");
    expect(angleText(0.2)).toBe("0°");
  });
});

describe("tools in the hand", () => {
  test("are put away by taking them again", () => {
    const tools = new SceneTools();
    tools.toggle("ruler");
    tools.set(at(0, 0));
    tools.toggle("ruler");
    expect(tools.tool.value).toBeNull();
    expect(tools.points.value).toEqual([]);
  });

  test("show what would be measured before the last point is set, and begin anew after it", () => {
    const tools = new SceneTools();
    tools.toggle("ruler");
    tools.set(at(0, 0));
    tools.draft.value = at(2, 0);
    expect(tools.result.value).toEqual({ kind: "distance", metres: 2 });
    tools.set(at(3, 0));
    expect(tools.isDone.value).toBe(true);
    tools.set(at(9, 9));
    expect(tools.result.value).toBeNull();
  });
});

describe("the start", () => {
  test("goes to tenths of a metre, or anywhere when free", () => {
    expect(movedTo(START, at(1.234, -0.77), null, false)).toMatchObject({ x_m: 1.2, y_m: -0.8 });
    expect(movedTo(START, at(1.234, -0.77), null, true)).toMatchObject({ x_m: 1.234, y_m: -0.77 });
  });

  test("stays clear of the outer walls", () => {
    expect(movedTo(START, at(9, -9), null, false)).toMatchObject({ x_m: 3.7, y_m: -3.7 });
  });

  test("faces where the knob is dragged, in steps of 15 degrees", () => {
    expect(facing(START, at(0.1, 1), false).heading_deg).toBe(90);
    expect(facing(START, at(1, -0.3), false).heading_deg).toBe(-15);
    const { x, y } = handleOf({ ...START, heading_deg: 90 });
    expect([x, y]).toEqual([expect.closeTo(0), expect.closeTo(0.5)]);
  });

  test("is moved and turned by keys", () => {
    expect(nudged(START, "ArrowUp", null, false)).toMatchObject({ x_m: 0, y_m: 0.1 });
    expect(nudged({ ...START, heading_deg: 180 }, ",", null, false).heading_deg).toBe(-165);
    expect(nudged(START, ">", null, true).heading_deg).toBe(-1);
  });

  test("never faces more than half a turn", () => {
    expect([turned(270), turned(-180), turned(360)]).toEqual([-90, 180, 0]);
  });
});

test("the floor under a place of the canvas is the one that is drawn there", () => {
  const [viewport, size] = [
    { x: 1, y: -2, scale: 80 },
    { width: 500, height: 300 },
  ];
  const place = toScreen(viewport, size, at(2.5, -1));
  const back = toFloor(viewport, size, place);
  expect([back.x, back.y]).toEqual([expect.closeTo(2.5), expect.closeTo(-1)]);
});

test("a pushed box glides to where it is, and is back at once when nothing is told of it", () => {
  const interpolator = new BoxInterpolator();
  interpolator.approach({ 0: [0, 0, 0] }, 16, false);
  expect(interpolator.approach({ 0: [1, 0, 0] }, 60, false)).toBe(true);
  expect(interpolator.poses[0]?.[0]).toBeCloseTo(0.632, 2);
  expect(interpolator.approach({ 0: [1, 0, 0] }, 16, true)).toBe(false);
  expect(interpolator.poses[0]).toEqual([1, 0, 0]);
  interpolator.approach({}, 16, false);
  expect(interpolator.poses).toEqual({});
});
