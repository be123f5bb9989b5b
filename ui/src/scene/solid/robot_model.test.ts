import { Box3 } from "three";
import { expect, test } from "vitest";
import type { Robot } from "../../api/model";
import type { Colours } from "../colours";
import { extentOf } from "../hull";
import { RobotModel, rolled } from "./robot_model";

const WHEEL = { x_m: 0, y_m: 0.165, radius_m: 0.0975, width_m: 0.05 };
const ROBOT = {
  radius_m: 0.2225,
  hull_m: [
    [0.2275, 0.065],
    [0.15, 0.1605],
    [-0.2275, 0.1605],
    [-0.2275, -0.1605],
    [0.15, -0.1605],
    [0.2275, -0.065],
  ],
  hull_round_m: 0.07,
  wheels: [WHEEL, { ...WHEEL, y_m: -0.165 }],
  sonars: [{ x_m: 0.2225, y_m: 0, angle_rad: 0 }],
  laser: null,
} as unknown as Robot;
const COLOURS = new Proxy({}, { get: () => "#334455" }) as Colours;
const DAY = { high: "#ffffff", low: "#ffffff", ambient: 2, sun: 1, isOutlined: false };
const AT_START = { x: 0, y: 0, yaw: 0 };

test("wheels roll as far as the robot drives, and against each other where it turns", () => {
  expect(rolled(AT_START, { x: 0.0975, y: 0, yaw: 0 }, WHEEL)).toBeCloseTo(1);
  expect(rolled(AT_START, { x: -0.0975, y: 0, yaw: 0 }, WHEEL)).toBeCloseTo(-1);
  const [left, right] = [WHEEL, { ...WHEEL, y_m: -0.165 }].map((wheel) =>
    rolled(AT_START, { x: 0, y: 0, yaw: 0.05 }, wheel),
  );
  expect(left).toBeCloseTo(-0.0846, 3);
  expect(right).toBeCloseTo(0.0846, 3);
});

test("the robot has the outline of its record, and stands on the floor", () => {
  const model = new RobotModel(ROBOT, COLOURS, DAY);
  const { min, max } = new Box3().setFromObject(model.group);
  const { front, back } = extentOf(ROBOT);
  expect(min.x).toBeCloseTo(back, 2);
  expect(max.x).toBeCloseTo(front, 2);
  expect(max.y).toBeCloseTo(0.19, 2); // the outer side of a wheel
  expect(min.z).toBeCloseTo(0, 3);
  model.dispose();
});
