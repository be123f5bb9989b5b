import type { GoalPicture } from "../../api/model";
import { type Box, include, roomOf } from "../frames";
import { includeThings } from "../subject";

export const WIDTH = 240;
export const HEIGHT = 150;
const MARGIN = 8;

/** Margins around the start, lines and whatever else is in the world, metres. */
const AROUND_START = 0.4;
const AROUND_LINE = 0.25;
/** A small figure is not enlarged further: the robot beside it tells how large it is. */
const LARGEST_SCALE = 84;

export type Pixels = readonly [x: number, y: number];

export interface GoalFrame {
  /** Pixels per metre. */
  readonly scale: number;
  /** The part of the floor that is seen, metres. */
  readonly box: Box;
  /** Converts a point of the world frame. */
  place(point: readonly number[]): Pixels;
}

/** The part of a goal's world that its picture shows: all that stands in the room, the start and the lines. */
export function frameOf({ world, lines }: GoalPicture): GoalFrame {
  const { x_m, y_m } = world.start;
  const box: Box = { left: x_m, right: x_m, bottom: y_m, top: y_m };
  include(box, x_m, y_m, AROUND_START);
  includeThings(box, world);
  for (const [x = 0, y = 0] of lines.flatMap(({ points }) => points)) {
    include(box, x, y, AROUND_LINE);
  }
  const scale = Math.min(
    LARGEST_SCALE,
    (WIDTH - 2 * MARGIN) / (box.right - box.left),
    (HEIGHT - 2 * MARGIN) / (box.top - box.bottom),
  );
  const [x0, y0] = [(box.left + box.right) / 2, (box.bottom + box.top) / 2];
  const place = ([x = 0, y = 0]: readonly number[]): Pixels => [
    rounded(WIDTH / 2 + (x - x0) * scale),
    rounded(HEIGHT / 2 - (y - y0) * scale),
  ];
  return { scale, place, box: seen(roomOf(world), scale, [x0, y0]) };
}

const rounded = (value: number) => Math.round(value * 10) / 10;

/** The whole picture in metres, without what lies outside of the room. */
function seen(room: Box, scale: number, [x, y]: readonly [number, number]): Box {
  const [wide, high] = [WIDTH / 2 / scale, HEIGHT / 2 / scale];
  return {
    left: Math.max(room.left, x - wide),
    right: Math.min(room.right, x + wide),
    bottom: Math.max(room.bottom, y - high),
    top: Math.min(room.top, y + high),
  };
}

/** The middle of a figure; its corners count once. */
export function middleOf(places: readonly Pixels[]): Pixels {
  const corners = [...new Map(places.map((place) => [place.join(), place])).values()];
  const n = Math.max(1, corners.length);
  const sum = (axis: 0 | 1) => corners.reduce((total, place) => total + place[axis], 0);
  return [sum(0) / n, sum(1) / n];
}
