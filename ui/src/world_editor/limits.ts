/** Limits of a world, the same as in `sim/document.py`; metres, and characters. */
export const LONGEST = 50;
export const SHORTEST = 0.05;
export const FLOOR_LEAST = 1;
export const NAME_MOST = 64;
export const TITLE_MOST = 60;
export const FILE_MOST_BYTES = 256 * 1024;
/** Mass of movable boxes, kilograms. */
export const PUSHED_LEAST_KG = 0.5;
export const PUSHED_MOST_KG = 20;
