import { lineThrough, outlineOf } from "../../scene/areas";
import { toScreen } from "../../scene/camera";
import type { XY } from "../../scene/frames";
import { pointsOf } from "../geometry";
import { isArea, type Thing } from "../plan";
import type { View } from "./board_view";

/** Converts a point of the floor to pixels of the board. */
export const onBoard = ({ camera, size }: View, point: XY): XY => toScreen(camera, size, point);

/** The edge of a thing as an SVG path, in pixels of the board. */
export function edgeOf(view: View, thing: Thing): string {
  const place = (point: XY) => onBoard(view, point);
  if (isArea(thing)) return outlineOf(thing, place, view.camera.scale);
  return lineThrough([thing.from, thing.to].map(place));
}

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
