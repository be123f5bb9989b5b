import type { BlockDefinition } from "../definition";
import { anything, command } from "./arguments";

const statement = { style: "functions", previousStatement: null, nextStatement: null } as const;

export const functions = [
  {
    type: "function_def",
    style: "functions",
    level: 3,
    makes: { function: true },
    icon: "puzzle",
    args0: [{ type: "field_function_name", name: "NAME" }],
    nextStatement: null,
    hat: "cap",
    mutator: "pinel_function",
  },
  {
    ...statement,
    ...command("call"),
    level: 3,
    icon: "puzzle",
    args0: [{ type: "field_label", name: "NAME", text: "" }],
    mutator: "pinel_call",
  },
  {
    type: "call_value",
    style: "functions",
    level: 3,
    makes: { expression: "call" },
    args0: [{ type: "field_label", name: "NAME", text: "" }],
    ...anything,
    mutator: "pinel_call",
  },
  {
    ...statement,
    type: "return_value",
    level: 3,
    makes: { action: "return" },
    icon: "corner",
    args0: [{ type: "input_value", name: "VALUE", key: "value", shadow: { number: 0 } }],
  },
  { ...statement, ...command("return"), level: 3, icon: "corner", args0: [] },
] as const satisfies readonly BlockDefinition[];
