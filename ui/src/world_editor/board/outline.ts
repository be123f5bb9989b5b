import { toScreen } from "../../scene/camera";
import type { XY } from "../../scene/frames";
import { cornersOf, pointsOf } from "../geometry";
import { isArea, type Thing } from "../plan";
import type { View } from "./board_view";

/** Converts a point of the floor to pixels of the board. */
export const onBoard = ({ camera, size }: View, point: XY): XY => toScreen(camera, size, point);

/** The edge of a thing as an SVG path, in pixels of the board. */
export function outlineOf(view: View, thing: Thing): string {
  if (!isArea(thing)) return line([thing.from, thing.to].map((end) => onBoard(view, end)));
  if (thing.radius === null) {
    return `${line(cornersOf(thing).map((corner) => onBoard(view, corner)))}Z`;
  }
  const { x, y } = onBoard(view, thing);
  const r = thing.radius * view.camera.scale;
  return `M${x - r} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0Z`;
}

const line = (points: readonly XY[]) => `M${points.map(({ x, y }) => `${x} ${y}`).join("L")}`;

/** Top, bottom and horizontal centre of a thing, where a note about it can be placed. Pixels. */
export function spanOf(view: View, thing: Thing): { x: number; top: number; bottom: number } {
  const shown = pointsOf(thing).map((point) => onBoard(view, point));
  const xs = shown.map(({ x }) => x);
  const ys = shown.map(({ y }) => y);
  return {
    x: (Math.min(...xs) + Math.max(...xs)) / 2,
    top: Math.min(...ys),
    bottom: Math.max(...ys),
  };
}
