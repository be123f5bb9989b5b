import type { Box, XY } from "../frames";

/** Maps the world frame to the canvas: `x`, `y` is the centre in metres, `scale` is in pixels per metre. */
export interface Viewport {
  x: number;
  y: number;
  scale: number;
}

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** Margins of a floor, in pixels. */
export type Edge = Readonly<Record<"left" | "right" | "top" | "bottom", number>>;

/** Margins for the rulers and the walls' thickness, in pixels. */
export const EDGE: Edge = { left: 34, right: 14, top: 14, bottom: 28 };
/** `EDGE` with space on the right for the tools over the floor, which must not hide a goal. */
export const EDGE_WITH_TOOLS: Edge = { ...EDGE, right: 66 };

/** `EDGE_WITH_TOOLS` with space at the top for the controls over the floor of the studio. */
export const EDGE_WITH_CONTROLS: Edge = { ...EDGE_WITH_TOOLS, top: EDGE.top + 54 };

/** Up to this height the tools are in two columns; see `scene.css`. */
const TWO_COLUMNS_PX = 344;
const COLUMN_PX = 44;

/** Margins without rulers. */
const BARE_EDGE: Edge = { left: 6, right: 6, top: 6, bottom: 6 };

/** Below this height a magnified floor has no rulers, whose numbers would cover it. */
const LOW_MAGNIFIED_PX = 200;

/** Below this height a floor has no space to spare for its controls; see `studio.css`. */
const LOW_PX = 230;

export const hasRulers = (magnification: number, { height }: Size): boolean =>
  magnification === 1 || height >= LOW_MAGNIFIED_PX;

/** The margins of a floor; one that is magnified, or beside which a sign is asked, has no tools. */
export function marginsOf(
  size: Size,
  magnification: number,
  hasControls: boolean,
  isAsked = false,
): Edge {
  if (magnification === 1 && isAsked) return EDGE;
  if (magnification !== 1) return hasRulers(magnification, size) ? EDGE : BARE_EDGE;
  if (hasControls && size.height <= LOW_PX) return EDGE_WITH_TOOLS;
  const edge = hasControls ? EDGE_WITH_CONTROLS : EDGE_WITH_TOOLS;
  return size.height > TWO_COLUMNS_PX ? edge : { ...edge, right: edge.right + COLUMN_PX };
}

const MIN_SCALE = 12;
const MAX_SCALE = 320;

export function viewportFor(box: Box, size: Size, edge = EDGE): Viewport {
  const width = Math.max(1, size.width - edge.left - edge.right);
  const height = Math.max(1, size.height - edge.top - edge.bottom);
  const scale = clampScale(
    Math.min(width / (box.right - box.left), height / (box.top - box.bottom)),
  );
  return {
    x: (box.left + box.right) / 2 - (edge.left - edge.right) / 2 / scale,
    y: (box.bottom + box.top) / 2 + (edge.top - edge.bottom) / 2 / scale,
    scale,
  };
}

export function clampScale(scale: number): number {
  return Math.min(MAX_SCALE, Math.max(MIN_SCALE, scale));
}

export function toScreen(viewport: Viewport, size: Size, point: XY): XY {
  return {
    x: size.width / 2 + (point.x - viewport.x) * viewport.scale,
    y: size.height / 2 - (point.y - viewport.y) * viewport.scale,
  };
}

export function toFloor(viewport: Viewport, size: Size, place: XY): XY {
  return {
    x: viewport.x + (place.x - size.width / 2) / viewport.scale,
    y: viewport.y - (place.y - size.height / 2) / viewport.scale,
  };
}

/** Moves a viewport one step towards another; returns true while it has not arrived. */
export function approach(
  viewport: Viewport,
  target: Viewport,
  elapsedMs: number,
  still: boolean,
): boolean {
  const part = still ? 1 : 1 - Math.exp(-elapsedMs / 90);
  viewport.x += (target.x - viewport.x) * part;
  viewport.y += (target.y - viewport.y) * part;
  viewport.scale *= (target.scale / viewport.scale) ** part;
  const off =
    Math.hypot(target.x - viewport.x, target.y - viewport.y) * viewport.scale +
    Math.abs(target.scale / viewport.scale - 1) * 400;
  if (off > 0.3) return true;
  Object.assign(viewport, target);
  return false;
}
