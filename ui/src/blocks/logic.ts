import type { BlockDefinition } from "./definition";
import { iconArgument, rowSpacer } from "./icons";

const statement = { style: "logic", previousStatement: null, nextStatement: null } as const;
const condition = { type: "input_value", name: "CONDITION", check: "Boolean" };
const body = (name: string) => ({ type: "input_statement", name });

const logicValue = { style: "logic", output: "Boolean", inputsInline: true } as const;
const side = (name: string, check: string) => ({ type: "input_value", name, check });

export const logic = [
  {
    ...statement,
    type: "if",
    args0: [iconArgument("split"), condition],
    message1: "%1",
    args1: [body("THEN")],
  },
  {
    ...statement,
    type: "if_else",
    args0: [iconArgument("split"), condition],
    message1: "%1",
    args1: [body("THEN")],
    message2: "%1 %{BKY_PINEL_ELSE}",
    args2: [rowSpacer],
    message3: "%1",
    args3: [body("ELSE")],
  },
  {
    ...logicValue,
    type: "compare",
    args0: [
      side("A", "Text"),
      {
        type: "field_dropdown",
        name: "OPERATOR",
        options: [
          ["=", "=="],
          ["≠", "!="],
        ],
      },
      side("B", "Text"),
    ],
  },
  {
    ...logicValue,
    type: "logic_operation",
    args0: [
      side("A", "Boolean"),
      {
        type: "field_dropdown",
        name: "OPERATOR",
        options: [
          ["%{BKY_PINEL_AND}", "and"],
          ["%{BKY_PINEL_OR}", "or"],
        ],
      },
      side("B", "Boolean"),
    ],
  },
  { ...logicValue, type: "not", args0: [side("A", "Boolean")] },
] as const satisfies readonly BlockDefinition[];
