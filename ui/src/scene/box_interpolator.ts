import type { BoxPoses } from "../run/reducer";

/** Time constant of the interpolation in ms; boxes are reported ten times a second. */
const TIME_MS = 60;
/** At this distance from the reported pose a box has arrived, metres and radians. */
const THERE = 1e-3;

/** Interpolates the drawn poses of pushed boxes towards the reported ones. */
export class BoxInterpolator {
  poses: BoxPoses = {};

  /**
   * Moves all boxes one step; returns true while a box has not arrived. A box without a reported
   * pose returns to its pose in the world document.
   */
  approach(boxes: BoxPoses, elapsedMs: number, still: boolean): boolean {
    const part = still ? 1 : 1 - Math.exp(-elapsedMs / TIME_MS);
    let moving = false;
    const poses: Record<string, readonly number[]> = {};
    for (const [index, goal] of Object.entries(boxes)) {
      const from = this.poses[index] ?? goal;
      const left = goal.map((value, axis) => value - (from[axis] ?? value));
      const isThere = still || left.every((distance) => Math.abs(distance) < THERE);
      moving ||= !isThere;
      poses[index] = isThere
        ? goal
        : goal.map((value, axis) => value - (left[axis] ?? 0) * (1 - part));
    }
    this.poses = poses;
    return moving;
  }
}
