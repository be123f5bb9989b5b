import type { BlockDefinition } from "../definition";
import { anything, nameField, numberInput } from "./arguments";

const statement = { style: "variables", previousStatement: null, nextStatement: null } as const;

export const variables = [
  {
    ...statement,
    type: "set_variable",
    level: 2,
    makes: { action: "set_variable" },
    icon: "box",
    args0: [
      nameField("NAME", "name"),
      { type: "input_value", name: "VALUE", key: "value", shadow: { number: 0 } },
    ],
  },
  {
    ...statement,
    type: "change_variable",
    level: 2,
    makes: { action: "change_variable" },
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
