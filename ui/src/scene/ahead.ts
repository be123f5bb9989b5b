import type { World } from "../api/model";
import type { BoxPoses, Pose } from "../run/reducer";
import { type Area, areaOf, WALL_M } from "./areas";

type Box = World["boxes"][number];

/** What the robot faces: its distance from the robot's centre in metres, and the box; a wall without one. */
export interface Ahead {
  readonly metres: number;
  readonly box: Box | null;
}

/** The nearest body on the line ahead of a robot, world frame; null if there is none. */
export function aheadOf(world: World, poses: BoxPoses, robot: Pose): Ahead | null {
  const walls = world.walls.map(({ from: [ax = 0, ay = 0], to: [bx = 0, by = 0] }) => {
    const size = [Math.hypot(bx - ax, by - ay) + WALL_M, WALL_M];
    const heading_deg = (Math.atan2(by - ay, bx - ax) * 180) / Math.PI;
    return {
      area: areaOf({ center: [(ax + bx) / 2, (ay + by) / 2], size, heading_deg }),
      box: null,
    };
  });
  const boxes = world.boxes.map((box, index) => ({ area: movedArea(box, poses[index]), box }));
  return [...walls, ...boxes].reduce<Ahead | null>((nearest, { area, box }) => {
    const metres = distanceTo(area, robot);
    return metres !== null && metres < (nearest?.metres ?? Infinity) ? { metres, box } : nearest;
  }, null);
}

function movedArea(box: Box, pose: readonly number[] | undefined): Area {
  const [x, y, yaw] = pose ?? [];
  if (x === undefined || y === undefined || yaw === undefined) return areaOf(box);
  return { ...areaOf(box), x, y, heading: (yaw * 180) / Math.PI };
}

/** Distance along a pose's heading to a rectangle; null if the line misses it. */
function distanceTo({ x, y, width, depth, heading }: Area, from: Pose): number | null {
  const angle = (heading * Math.PI) / 180;
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const [dx, dy] = [from.x - x, from.y - y];
  const [ux, uy] = [Math.cos(from.yaw - angle), Math.sin(from.yaw - angle)];
  const [px, py] = [dx * cos + dy * sin, dy * cos - dx * sin];
  const [nearX, farX] = slab(px, ux, width / 2);
  const [nearY, farY] = slab(py, uy, depth / 2);
  const [near, far] = [Math.max(nearX, nearY), Math.min(farX, farY)];
  return far < 0 || near > far ? null : Math.max(0, near);
}

/** Where a line enters and leaves the strip from -half to half. */
function slab(at: number, direction: number, half: number): [number, number] {
  if (Math.abs(direction) < 1e-9) return Math.abs(at) <= half ? [-Infinity, Infinity] : [1, -1];
  const [a, b] = [(-half - at) / direction, (half - at) / direction];
  return [Math.min(a, b), Math.max(a, b)];
}
