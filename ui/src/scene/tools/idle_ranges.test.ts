import { expect, test } from "vitest";
import type { Robot, World } from "../../api/model";
import { idleRanges } from "./idle_ranges";

const WORLD = {
  size_m: [8, 8],
  walls: [{ from: [2, -4], to: [2, 4] }],
  boxes: [{ center: [0, 1.5], size: [1, 1], heading_deg: 0, movable: false }],
  start: { x_m: 0, y_m: 0, heading_deg: 0 },
} as unknown as World;
const ROBOT = {
  sonars: [
    { x_m: 0.2, y_m: 0, angle_rad: 0 },
    { x_m: 0, y_m: 0, angle_rad: Math.PI / 2 },
    { x_m: 0, y_m: 0, angle_rad: Math.PI },
  ],
  sonar_range_m: 5,
  laser: { x_m: 0, y_m: 0, field_deg: 180, min_m: 0.1, range_m: 8 },
} as unknown as Robot;
const START = { x: 0, y: 0, yaw: 0 };

test("before a run, sonars reach the nearest wall or box, at most their range", () => {
  const { sonar, lidar } = idleRanges(ROBOT, WORLD, {}, START, ["sonar"]) ?? {};
  expect(sonar?.[0]).toBeCloseTo(1.8, 1);
  expect(sonar?.[1]).toBeCloseTo(1);
  expect(sonar?.[2]).toBe(5);
  expect(lidar).toBeNull();
});

test("the laser scanner has a beam for each degree, from the right to the left", () => {
  const { sonar, lidar } = idleRanges(ROBOT, WORLD, {}, START, ["lidar"]) ?? {};
  expect(sonar).toBeNull();
  expect(lidar).toHaveLength(181);
  expect(lidar?.[0]).toBe(8);
  expect(lidar?.[90]).toBeCloseTo(2, 1);
  expect(lidar?.[180]).toBeCloseTo(1);
});

test("beams turn with the robot and with the start", () => {
  const turned = { ...WORLD, start: { x_m: 0, y_m: 0, heading_deg: 90 } } as World;
  expect(idleRanges(ROBOT, turned, {}, START, ["sonar"])?.sonar?.[0]).toBeCloseTo(0.8);
  const pose = { x: 0, y: 0, yaw: Math.PI / 2 };
  expect(idleRanges(ROBOT, WORLD, {}, pose, ["sonar"])?.sonar?.[0]).toBeCloseTo(0.8);
});

test("a pushed box is where it stands", () => {
  const poses = { 0: [0, 2.5, 0] };
  expect(idleRanges(ROBOT, WORLD, poses, START, ["sonar"])?.sonar?.[1]).toBeCloseTo(2);
});

test("sensors that are not chosen are not drawn", () => {
  expect(idleRanges(ROBOT, WORLD, {}, START, [])).toBeNull();
});
