import type { BlockDefinition } from "./definition";
import { iconArgument } from "./icons";

const statement = { style: "motion", previousStatement: null, nextStatement: null } as const;

const distance = {
  type: "field_measure",
  name: "DISTANCE",
  value: 1,
  min: 0,
  max: 100,
  precision: 0.01,
};

export const motion = [
  { ...statement, type: "move_forward", args0: [iconArgument("arrowUp"), distance] },
  { ...statement, type: "move_backward", args0: [iconArgument("arrowDown"), distance] },
  {
    ...statement,
    type: "turn",
    args0: [
      iconArgument("rotateLeft"),
      {
        type: "field_dropdown",
        name: "DIRECTION",
        options: [
          ["%{BKY_PINEL_LEFT}", "LEFT"],
          ["%{BKY_PINEL_RIGHT}", "RIGHT"],
        ],
      },
      { type: "field_measure", name: "ANGLE", value: 90, min: 0, max: 360, precision: 0.1 },
    ],
    extensions: ["turn_arrow"],
  },
  { ...statement, type: "stop", args0: [iconArgument("stop")] },
] as const satisfies readonly BlockDefinition[];
