// Made by `python -m scripts.reference` from what Python declares. Do not edit.

/** Limits of parameters: pinel_desktop/program/limits.py. */
export const PROGRAM_LIMITS = {
  MAX_DISTANCE_M: 100,
  MAX_ANGLE_DEG: 3600,
  MAX_WAIT_S: 600,
  MAX_LIST: 10000,
  MAX_REPEATS: 100000,
} as const;

/** Commands that move the robot: pinel_desktop/program/model.py. */
export const MOTIONS = [
  "move_forward",
  "move_backward",
  "turn",
  "drive",
  "arc",
  "go_to",
  "go_to_place",
] as const;

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

/** The world of a program for which none was chosen: sim/world.py. */
export const DEFAULT_WORLD = "empty_room";

/** The robot model of a program for which none was chosen: pinel_desktop/robot/models.py. */
export const DEFAULT_ROBOT = "pioneer_3dx";

/** Limits of stored texts, in characters: storage/limits.py. */
export const STORE_LIMITS = {
  MAX_NAME: 60,
  MAX_NOTE: 1000,
  MAX_SIGN: 30,
  MAX_TAUGHT_SAMPLES: 20,
} as const;

/** Colours of groups: storage/choices.py. */
export const GROUP_COLORS = [
  "#1f6f8b",
  "#b3541e",
  "#5b4b9a",
  "#2e7d4f",
  "#a03561",
  "#8a6a00",
  "#34568b",
  "#7a3e3e",
  "#00796b",
  "#6d5d4b",
  "#9c3d97",
  "#4a6b1c",
] as const;

/** Patterns of a group's robot: storage/choices.py. */
export const ROBOT_PATTERNS = [
  "waves",
  "stripes",
  "dots",
  "checks",
  "star",
  "plain",
] as const;

/** Letters that the camera knows untaught: pinel_desktop/gestures/letters.py. */
export const LETTERS = [
  "A",
  "B",
  "C",
  "D",
  "E",
  "F",
  "G",
  "I",
  "K",
  "L",
  "M",
  "N",
  "O",
  "P",
  "Q",
  "R",
  "S",
  "T",
  "U",
  "V",
  "W",
] as const;
