import type { BlockDefinition } from "../definition";
import { ANGLE, choice, command, DISTANCE, numberInput, PLACE, SPEED, sides } from "./arguments";

const statement = { style: "motion", previousStatement: null, nextStatement: null } as const;
const routes = choice("AVOID", "avoid", [
  ["%{BKY_PINEL_STRAIGHT}", "FALSE"],
  ["%{BKY_PINEL_AROUND}", "TRUE"],
]);
const distance = numberInput("DISTANCE", "distance", 1, DISTANCE);

export const motion = [
  { ...statement, ...command("move_forward"), level: 1, icon: "arrowUp", args0: [distance] },
  { ...statement, ...command("move_backward"), level: 1, icon: "arrowDown", args0: [distance] },
  {
    ...statement,
    ...command("turn"),
    level: 1,
    icon: "rotateLeft",
    args0: [sides, numberInput("ANGLE", "angle", 90, ANGLE)],
    extensions: ["turn_arrow"],
  },
  { ...statement, ...command("stop"), level: 1, icon: "stop", args0: [] },
  {
    ...statement,
    ...command("arc"),
    level: 2,
    icon: "spline",
    args0: [
      sides,
      numberInput("RADIUS", "radius", 1, PLACE),
      numberInput("ANGLE", "angle", 90, ANGLE),
    ],
  },
  {
    ...statement,
    ...command("go_to"),
    level: 2,
    icon: "mapPin",
    args0: [numberInput("X", "x", 1, PLACE), numberInput("Y", "y", 0, PLACE), routes],
  },
  {
    ...statement,
    ...command("go_to_place"),
    level: 2,
    icon: "mapPin",
    args0: [
      {
        type: "input_value",
        name: "PLACE",
        key: "place",
        check: "String",
        shadow: { textKey: "PLACE_NAME" },
      },
      routes,
    ],
  },
  {
    ...statement,
    type: "set_speed_linear",
    level: 2,
    makes: { action: "set_speed" },
    icon: "gauge",
    args0: [numberInput("LINEAR", "linear", 0.4, SPEED)],
  },
  {
    ...statement,
    type: "set_speed_angular",
    level: 2,
    makes: { action: "set_speed" },
    icon: "gauge",
    args0: [numberInput("ANGULAR", "angular", 60, SPEED)],
  },
  {
    ...statement,
    ...command("set_speed"),
    level: 3,
    icon: "gauge",
    args0: [
      numberInput("LINEAR", "linear", 0.4, SPEED),
      numberInput("ANGULAR", "angular", 60, SPEED),
    ],
  },
  {
    ...statement,
    ...command("drive"),
    level: 2,
    icon: "chevronsUp",
    args0: [numberInput("LINEAR", "linear", 0.2), numberInput("ANGULAR", "angular", 0)],
  },
] as const satisfies readonly BlockDefinition[];
