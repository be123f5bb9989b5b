import type { BlockDefinition } from "../definition";
import { command, numberInput, TEXT_LITERAL, TIMEOUT } from "./arguments";

const statement = { style: "gestures", previousStatement: null, nextStatement: null } as const;

export const gestures = [
  {
    ...statement,
    ...command("classify_gestures"),
    level: 1,
    icon: "hand",
    args0: [numberInput("TIMEOUT", "timeout", 10, TIMEOUT)],
  },
  {
    type: "gesture_result",
    style: "gestures",
    level: 1,
    makes: { expression: "gesture" },
    args0: [],
    output: "String",
  },
  {
    type: "text_letter",
    style: "gestures",
    level: 1,
    makes: { expression: "literal" },
    args0: [{ type: "field_sign", name: "TEXT" }],
    output: TEXT_LITERAL,
  },
  {
    ...statement,
    ...command("read_number"),
    level: 1,
    icon: "hand",
    args0: [numberInput("TIMEOUT", "timeout", 10, TIMEOUT)],
  },
  {
    type: "number_shown",
    style: "gestures",
    level: 1,
    makes: { expression: "gesture" },
    args0: [],
    output: "Number",
  },
  {
    ...statement,
    ...command("set_gesture_result"),
    level: 1,
    icon: "pencil",
    args0: [
      {
        type: "input_value",
        name: "RESULT",
        key: "result",
        check: "String",
        shadow: { letter: "B" },
      },
    ],
  },
] as const satisfies readonly BlockDefinition[];
