import type { BlockDefinition } from "../definition";
import { anything, command, nameField, numberInput } from "./arguments";

const statement = { style: "variables", previousStatement: null, nextStatement: null } as const;

export const variables = [
  {
    ...statement,
    ...command("set_variable"),
    level: 2,
    icon: "box",
    args0: [
      nameField("NAME", "name"),
      { type: "input_value", name: "VALUE", key: "value", shadow: { number: 0 } },
    ],
  },
  {
    ...statement,
    ...command("change_variable"),
    level: 2,
    icon: "diff",
    args0: [nameField("NAME", "name"), numberInput("BY", "by", 1)],
  },
  {
    type: "variable",
    style: "variables",
    level: 2,
    makes: { expression: "variable" },
    args0: [{ type: "field_name", name: "NAME" }],
    ...anything,
  },
] as const satisfies readonly BlockDefinition[];
