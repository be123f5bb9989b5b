// Made by `python -m scripts.reference` from what Python declares. Do not edit.

/** Limits of parameters: pinel_desktop/program/limits.py. */
export const PROGRAM_LIMITS = {
  MAX_DISTANCE_M: 100,
  MAX_ANGLE_DEG: 3600,
  MAX_WAIT_S: 600,
  MAX_REPEATS: 100000,
} as const;

/** Limits of a world: sim/document.py, floor.py, world.py. */
export const WORLD_LIMITS = {
  MAX_BYTES: 262144,
  MAX_NAME: 64,
  MAX_TITLE: 60,
  MIN_FLOOR_M: 1,
  MAX_FLOOR_M: 50,
  MIN_MOVABLE_SIDE_M: 0.05,
  MIN_MOVABLE_KG: 0.5,
  MAX_MOVABLE_KG: 20,
} as const;

/** Limits of what is kept, in letters: storage/limits.py. */
export const STORE_LIMITS = {
  MAX_NAME: 60,
  MAX_NOTE: 1000,
} as const;
