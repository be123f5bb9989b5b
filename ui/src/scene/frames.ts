import type { World } from "../api/model";

/** Distance from the robot's centre to its turning handle. */
export const HANDLE_M = 0.5;

/** Pose of a run's start frame in the world frame: metres and radians. */
export interface StartPose {
  readonly x: number;
  readonly y: number;
  readonly yaw: number;
}

export interface XY {
  readonly x: number;
  readonly y: number;
}

export interface Box {
  left: number;
  right: number;
  bottom: number;
  top: number;
}

export function startOf(world: World | null): StartPose {
  if (!world) return { x: 0, y: 0, yaw: 0 };
  const { x_m, y_m, heading_deg } = world.start;
  return { x: x_m, y: y_m, yaw: (heading_deg * Math.PI) / 180 };
}

/** Moves the canvas from the world frame to the start frame. */
export function toStartFrame(ctx: CanvasRenderingContext2D, world: World | null): void {
  const start = startOf(world);
  ctx.translate(start.x, start.y);
  ctx.rotate(start.yaw);
}

/** Transforms a point from the start frame to the world frame. */
export function toWorld(start: StartPose, x: number, y: number): XY {
  const cos = Math.cos(start.yaw);
  const sin = Math.sin(start.yaw);
  return { x: start.x + x * cos - y * sin, y: start.y + x * sin + y * cos };
}

/** Transforms a point from the world frame to the start frame. */
export function toStart(start: StartPose, x: number, y: number): XY {
  const cos = Math.cos(start.yaw);
  const sin = Math.sin(start.yaw);
  const dx = x - start.x;
  const dy = y - start.y;
  return { x: dx * cos + dy * sin, y: -dx * sin + dy * cos };
}

export function roomOf(world: World | null): Box {
  const [width, depth] = world?.size_m ?? [8, 8];
  return { left: -width / 2, right: width / 2, bottom: -depth / 2, top: depth / 2 };
}

export function include(box: Box, x: number, y: number, margin = 0): void {
  box.left = Math.min(box.left, x - margin);
  box.right = Math.max(box.right, x + margin);
  box.bottom = Math.min(box.bottom, y - margin);
  box.top = Math.max(box.top, y + margin);
}
