import type { BlockDefinition } from "../definition";
import { anything, command, nameField, numberInput, operation, POSITION } from "./arguments";

const valueSought = { type: "input_value", name: "VALUE", shadow: { textKey: "WORD" } } as const;

export const lists = [
  {
    type: "list_of",
    style: "lists",
    level: 3,
    makes: { expression: "list" },
    args0: [],
    output: "Array",
    variadic: { check: "Literal", min: 0, start: 3, shadow: { number: 0 } },
    mutator: "pinel_variadic",
  },
  {
    type: "list_data",
    style: "lists",
    level: 3,
    makes: { expression: "list" },
    args0: [{ type: "field_label", name: "COUNT", text: "0" }],
    output: "Array",
    mutator: "pinel_list_data",
    hidden: true,
  },
  {
    ...command("append"),
    style: "lists",
    level: 3,
    icon: "listPlus",
    previousStatement: null,
    nextStatement: null,
    args0: [
      { type: "input_value", name: "VALUE", key: "value", shadow: { number: 0 } },
      nameField("LIST", "list"),
    ],
  },
  {
    ...command("replace_item"),
    style: "lists",
    level: 3,
    icon: "replace",
    previousStatement: null,
    nextStatement: null,
    args0: [
      numberInput("POSITION", "position", 1, POSITION),
      nameField("LIST", "list"),
      { type: "input_value", name: "VALUE", key: "value", shadow: { number: 0 } },
    ],
  },
  {
    ...operation("item"),
    style: "lists",
    level: 3,
    args0: [
      {
        type: "input_value",
        name: "INDEX",
        check: "Number",
        shadow: { number: 1 },
        limits: { precision: 1 },
      },
      { type: "input_value", name: "LIST", check: "Array" },
    ],
    ...anything,
  },
  {
    ...operation("contains"),
    style: "lists",
    level: 3,
    args0: [{ type: "input_value", name: "LIST", check: "Array" }, valueSought],
    output: "Boolean",
  },
  {
    ...operation("position_of"),
    style: "lists",
    level: 3,
    args0: [valueSought, { type: "input_value", name: "LIST", check: "Array" }],
    output: "Number",
  },
  {
    ...operation("length"),
    style: "lists",
    level: 3,
    args0: [{ type: "input_value", name: "A", check: ["String", "Array"] }],
    output: "Number",
  },
] as const satisfies readonly BlockDefinition[];
