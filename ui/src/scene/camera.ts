import type { Box, XY } from "./frames";

/** Maps the world frame to the canvas: `x`, `y` is the centre in metres, `scale` is in pixels per metre. */
export interface Camera {
  x: number;
  y: number;
  scale: number;
}

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** Margins for the rulers and the walls' thickness, in pixels. */
export const EDGE = { left: 34, right: 14, top: 14, bottom: 28 };
/** The same with room on the right for the tools over the floor, which must not hide a goal. */
export const EDGE_WITH_TOOLS = { ...EDGE, right: 66 };

const MIN_SCALE = 12;
const MAX_SCALE = 320;

export function cameraFor(box: Box, size: Size, edge = EDGE): Camera {
  const width = Math.max(1, size.width - edge.left - edge.right);
  const height = Math.max(1, size.height - edge.top - edge.bottom);
  const scale = clampScale(
    Math.min(width / (box.right - box.left), height / (box.top - box.bottom)),
  );
  // spare height goes to the top, where controls lie over the floor
  return {
    x: (box.left + box.right) / 2 - (edge.left - edge.right) / 2 / scale,
    y: box.bottom + (size.height / 2 - edge.bottom) / scale,
    scale,
  };
}

export function clampScale(scale: number): number {
  return Math.min(MAX_SCALE, Math.max(MIN_SCALE, scale));
}

export function toScreen(camera: Camera, size: Size, point: XY): XY {
  return {
    x: size.width / 2 + (point.x - camera.x) * camera.scale,
    y: size.height / 2 - (point.y - camera.y) * camera.scale,
  };
}

export function toFloor(camera: Camera, size: Size, place: XY): XY {
  return {
    x: camera.x + (place.x - size.width / 2) / camera.scale,
    y: camera.y - (place.y - size.height / 2) / camera.scale,
  };
}

/** Moves a camera one step towards another; true while it has not arrived. */
export function approach(
  camera: Camera,
  target: Camera,
  elapsedMs: number,
  still: boolean,
): boolean {
  const part = still ? 1 : 1 - Math.exp(-elapsedMs / 90);
  camera.x += (target.x - camera.x) * part;
  camera.y += (target.y - camera.y) * part;
  camera.scale *= (target.scale / camera.scale) ** part;
  const off =
    Math.hypot(target.x - camera.x, target.y - camera.y) * camera.scale +
    Math.abs(target.scale / camera.scale - 1) * 400;
  if (off > 0.3) return true;
  Object.assign(camera, target);
  return false;
}
