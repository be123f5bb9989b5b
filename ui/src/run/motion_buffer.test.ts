import { expect, test } from "vitest";
import { between, MotionBuffer } from "./motion_buffer";

const TICK_MS = 1000 / 30;
const pose = (x: number, yaw = 0) => ({ x, y: 0, yaw });

test("between two samples the robot is between two places", () => {
  const buffer = new MotionBuffer();
  for (let tick = 0; tick < 6; tick++) buffer.push(tick, pose(tick), 1000 + tick * TICK_MS);
  const now = 1000 + 5.2 * TICK_MS;
  expect(buffer.at(now)?.x).toBeCloseTo(3.7);
});

test("without news it comes to rest at the last sample", () => {
  const buffer = new MotionBuffer();
  buffer.push(0, pose(0), 0);
  buffer.push(1, pose(1), TICK_MS);
  expect(buffer.at(5000)?.x).toBe(1);
});

test("a new run does not start where the last one ended", () => {
  const buffer = new MotionBuffer();
  for (let tick = 0; tick < 9; tick++) buffer.push(tick, pose(tick), tick * TICK_MS);
  buffer.push(0, pose(0), 9 * TICK_MS);
  expect(buffer.at(9 * TICK_MS)?.x).toBe(0);
});

test("nothing is known before the first sample", () => {
  expect(new MotionBuffer().at(0)).toBeNull();
});

test("a turn across the back goes the short way", () => {
  const turned = between(pose(0, 3), pose(0, -3), 0.5).yaw;
  expect(Math.abs(turned)).toBeGreaterThan(3);
});
