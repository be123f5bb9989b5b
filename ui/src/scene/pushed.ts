import type { Things } from "../run/reducer";

/** Of the way to where a box is now, what is left after so long: boxes are told ten times a second, ms. */
const TIME_MS = 60;
/** Nearer than this it has arrived, metres and radians. */
const THERE = 1e-3;

/** Where pushed boxes are drawn: gliding from what was told to what is told. */
export class Pushed {
  places: Things = {};

  /** Moves all boxes on their way; true while one has not arrived. What is no longer told is back in its place. */
  approach(things: Things, elapsedMs: number, still: boolean): boolean {
    const part = still ? 1 : 1 - Math.exp(-elapsedMs / TIME_MS);
    let moving = false;
    const places: Record<string, readonly number[]> = {};
    for (const [index, goal] of Object.entries(things)) {
      const from = this.places[index] ?? goal;
      const left = goal.map((value, axis) => value - (from[axis] ?? value));
      const isThere = still || left.every((way) => Math.abs(way) < THERE);
      moving ||= !isThere;
      places[index] = isThere
        ? goal
        : goal.map((value, axis) => value - (left[axis] ?? 0) * (1 - part));
    }
    this.places = places;
    return moving;
  }
}
