import { lineThrough, outlineOf } from "../../scene/areas";
import type { XY } from "../../scene/frames";
import { toScreen } from "../../scene/framing/viewport";
import { pointsOf } from "../geometry";
import { isArea, type WorldObject } from "../plan";
import type { View } from "./board_view";

/** Converts a point of the floor to pixels of the board. */
export const onBoard = ({ viewport, size }: View, point: XY): XY => toScreen(viewport, size, point);

/** The edge of an object as an SVG path, in pixels of the board. */
export function edgeOf(view: View, object: WorldObject): string {
  const place = (point: XY) => onBoard(view, point);
  if (isArea(object)) return outlineOf(object, place, view.viewport.scale);
  return lineThrough([object.from, object.to].map(place));
}

/** Top, bottom and horizontal centre of an object, for the position of its note; pixels. */
export function spanOf(
  view: View,
  object: WorldObject,
): { x: number; top: number; bottom: number } {
  const shown = pointsOf(object).map((point) => onBoard(view, point));
  const xs = shown.map(({ x }) => x);
  const ys = shown.map(({ y }) => y);
  return {
    x: (Math.min(...xs) + Math.max(...xs)) / 2,
    top: Math.min(...ys),
    bottom: Math.max(...ys),
  };
}
