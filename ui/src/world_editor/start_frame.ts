import { type StartPose, toStart, toWorld, type XY } from "../scene/frames";
import { clean } from "./geometry";
import type { FloorPlan, Start } from "./plan";

/** Range and step of a number field. */
export interface Range {
  min: number;
  max: number;
  step: number;
}

/** Rounds metres of the document finely: with a rotated start, the field still shows a number as typed. */
const exact = (value: number) => Math.round(value * 1e6) / 1e6 + 0;

const poseOf = ({ x, y, heading }: Start): StartPose => ({ x, y, yaw: (heading * Math.PI) / 180 });

/** Converts a point of the world frame to the start frame: metres ahead of the start and to its left. */
export function fromStart(start: Start, point: XY): XY {
  const { x, y } = toStart(poseOf(start), point.x, point.y);
  return { x: clean(x), y: clean(y) };
}

/** Converts a point of the start frame, metres ahead of the start and to its left, to the world frame. */
export function onFloor(start: Start, counted: XY): XY {
  const { x, y } = toWorld(poseOf(start), counted.x, counted.y);
  return { x: exact(x), y: exact(y) };
}

/** Range of the floor along an axis of the start frame, metres. */
export function reach({ start, width, depth }: FloorPlan, axis: "x" | "y", step: number): Range {
  const corners = [-1, 1].flatMap((right) =>
    [-1, 1].map((up) => fromStart(start, { x: (right * width) / 2, y: (up * depth) / 2 })[axis]),
  );
  return { min: Math.min(...corners), max: Math.max(...corners), step };
}
