// Made by `python -m scripts.reference` from pinel_desktop/program/sensors.py. Do not edit.

/** The blocks that read sensors; those with several sensors let one of them be chosen. */
export const SENSOR_ROWS = [
  { type: "distance_sensor", level: 2, gives: "Number", sensors: ["distance"], asked: { key: "direction", choices: ["front", "left", "right", "back"] } },
  { type: "bumper", level: 2, gives: "Boolean", sensors: ["bumper"], asked: null },
  { type: "position", level: 2, gives: "Number", sensors: ["x", "y"], asked: null },
  { type: "heading", level: 2, gives: "Number", sensors: ["heading"], asked: null },
  { type: "time", level: 2, gives: "Number", sensors: ["time"], asked: null },
  { type: "floor", level: 2, gives: "String", sensors: ["floor"], asked: null },
  { type: "has_mark", level: 2, gives: "Boolean", sensors: ["has_mark"], asked: null },
  { type: "mark_here", level: 2, gives: "String", sensors: ["mark_here"], asked: null },
  { type: "cell", level: 3, gives: "String", sensors: ["cell"], asked: null },
  { type: "compass", level: 3, gives: "Number", sensors: ["compass"], asked: null },
  { type: "sonar", level: 3, gives: "Number", sensors: ["sonar"], asked: { key: "index", start: 0, limits: { min: 0, max: 15, precision: 1 } } },
  { type: "lidar", level: 3, gives: "Number", sensors: ["lidar"], asked: { key: "angle", start: 0, limits: { min: -180, max: 180, precision: 0.1 } } },
] as const;
