import type { GoalPicture } from "../../api/model";
import { type Box, include, roomOf, type XY } from "../frames";
import { includeObjects } from "../framing/content_bounds";

export const WIDTH = 240;
export const HEIGHT = 150;

/** Margins around the start and around lines, metres. */
const AROUND_START = 0.4;
const AROUND_LINE = 0.25;

/** Margin of a picture in pixels, and its maximum scale in pixels per metre: small goals stay comparable. */
const OF_GOAL = { margin: 8, maxScale: 84 };
const OF_PATH = { margin: 24, maxScale: 56 };

/** Minimum size of the shown part of the floor, metres. */
const MIN_SIZE_M = 0.1;

/** Maps a part of the floor to a small picture. */
export interface GoalViewport {
  /** Pixels per metre. */
  readonly scale: number;
  /** The visible part of the floor, metres. */
  readonly box: Box;
  /** Converts a point of the floor to pixels of the picture. */
  toPixels(point: XY): XY;
}

/** The viewport of a goal: contains all objects in the room, the start and the lines. */
export function viewportOfGoal({ world, lines }: GoalPicture): GoalViewport {
  const { x_m, y_m } = world.start;
  const box: Box = { left: x_m, right: x_m, bottom: y_m, top: y_m };
  include(box, x_m, y_m, AROUND_START);
  includeObjects(box, world);
  for (const [x = 0, y = 0] of lines.flatMap(({ points }) => points)) {
    include(box, x, y, AROUND_LINE);
  }
  return fitted(box, OF_GOAL, roomOf(world));
}

/** The viewport of a path: contains the path with its start. */
export function viewportOfPath(path: readonly XY[]): GoalViewport {
  const box: Box = { left: 0, right: 0, bottom: 0, top: 0 };
  for (const { x, y } of path) include(box, x, y);
  return fitted(box, OF_PATH);
}

/** Fits a part of the floor into the picture and clips the visible surroundings at the room. */
function fitted(part: Box, { margin, maxScale }: typeof OF_GOAL, room?: Box): GoalViewport {
  const scale = Math.min(
    maxScale,
    (WIDTH - 2 * margin) / Math.max(MIN_SIZE_M, part.right - part.left),
    (HEIGHT - 2 * margin) / Math.max(MIN_SIZE_M, part.top - part.bottom),
  );
  const [x0, y0] = [(part.left + part.right) / 2, (part.bottom + part.top) / 2];
  const [wide, high] = [WIDTH / 2 / scale, HEIGHT / 2 / scale];
  const box = {
    left: Math.max(room?.left ?? -Infinity, x0 - wide),
    right: Math.min(room?.right ?? Infinity, x0 + wide),
    bottom: Math.max(room?.bottom ?? -Infinity, y0 - high),
    top: Math.min(room?.top ?? Infinity, y0 + high),
  };
  const toPixels = ({ x, y }: XY): XY => ({
    x: rounded(WIDTH / 2 + (x - x0) * scale),
    y: rounded(HEIGHT / 2 - (y - y0) * scale),
  });
  return { scale, toPixels, box };
}

const rounded = (value: number) => Math.round(value * 10) / 10;

/** Converts the points of a document or of a recorded run. */
export const pointsOf = (path: readonly (readonly number[])[]): XY[] =>
  path.map(([x = 0, y = 0]) => ({ x, y }));

/** The mean of a figure's corners; each corner counts once, even if the line passes it twice. */
export function middleOf(places: readonly XY[]): XY {
  const corners = [...new Map(places.map((place) => [`${place.x} ${place.y}`, place])).values()];
  const n = Math.max(1, corners.length);
  const mean = (axis: "x" | "y") => corners.reduce((sum, place) => sum + place[axis], 0) / n;
  return { x: mean("x"), y: mean("y") };
}
