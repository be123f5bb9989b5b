import { colourOptions, TEXT_LITERAL } from "./arguments";
import type { BlockDefinition } from "./definition";

const measure = { style: "sensing", output: "Number" } as const;

export const sensing = [
  {
    ...measure,
    type: "distance_sensor",
    level: 2,
    makes: { sensor: ["distance"] },
    args0: [
      {
        type: "field_dropdown",
        name: "DIRECTION",
        options: [
          ["%{BKY_PINEL_FRONT}", "front"],
          ["%{BKY_PINEL_LEFT}", "left"],
          ["%{BKY_PINEL_RIGHT}", "right"],
          ["%{BKY_PINEL_BACK}", "back"],
        ],
      },
    ],
  },
  {
    type: "bumper",
    style: "sensing",
    level: 2,
    makes: { sensor: ["bumper"] },
    args0: [],
    output: "Boolean",
  },
  {
    ...measure,
    type: "position",
    level: 2,
    makes: { sensor: ["x", "y"] },
    args0: [
      {
        type: "field_dropdown",
        name: "AXIS",
        options: [
          ["x", "x"],
          ["y", "y"],
        ],
      },
    ],
  },
  { ...measure, type: "heading", level: 2, makes: { sensor: ["heading"] }, args0: [] },
  { ...measure, type: "time", level: 2, makes: { sensor: ["time"] }, args0: [] },
  {
    type: "floor",
    style: "sensing",
    level: 2,
    makes: { sensor: ["floor"] },
    args0: [],
    output: "String",
  },
  {
    type: "colour",
    style: "sensing",
    level: 2,
    makes: { expression: "literal" },
    args0: [{ type: "field_dropdown", name: "COLOUR", options: colourOptions }],
    output: TEXT_LITERAL,
  },
  {
    type: "cell",
    style: "sensing",
    level: 3,
    makes: { sensor: ["cell"] },
    args0: [],
    output: "String",
  },
  {
    ...measure,
    type: "sonar",
    level: 3,
    makes: { sensor: ["sonar"] },
    args0: [
      {
        type: "input_value",
        name: "INDEX",
        check: "Number",
        shadow: { number: 0 },
        limits: { min: 0, max: 15, precision: 1 },
      },
    ],
  },
  {
    ...measure,
    type: "lidar",
    level: 3,
    makes: { sensor: ["lidar"] },
    args0: [
      {
        type: "input_value",
        name: "ANGLE",
        check: "Number",
        shadow: { number: 0 },
        limits: { min: -90, max: 90, precision: 0.1 },
      },
    ],
  },
] as const satisfies readonly BlockDefinition[];
