import type { BlockDefinition } from "./definition";
import { iconArgument } from "./icons";

const statement = { style: "flow", previousStatement: null, nextStatement: null } as const;

export const flow = [
  {
    ...statement,
    type: "repeat",
    args0: [
      iconArgument("repeat"),
      { type: "field_measure", name: "TIMES", value: 4, min: 1, max: 1000, precision: 1 },
    ],
    message1: "%1",
    args1: [{ type: "input_statement", name: "DO" }],
  },
  {
    ...statement,
    type: "wait",
    args0: [
      iconArgument("clock"),
      { type: "field_measure", name: "SECONDS", value: 1, min: 0, max: 600, precision: 0.1 },
    ],
  },
] as const satisfies readonly BlockDefinition[];
