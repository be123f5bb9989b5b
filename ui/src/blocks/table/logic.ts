import type { BlockDefinition, ValueType } from "../definition";
import { BOOLEAN_LITERAL, dropdown, operation } from "./arguments";

const logicValue = { style: "logic", output: "Boolean" } as const;
const side = (name: string, check?: ValueType) => ({
  type: "input_value",
  name,
  ...(check && { check }),
});

export const COMPARISONS = ["==", "!=", "<", "<=", ">", ">="] as const;

export const logic = [
  {
    type: "if",
    style: "logic",
    level: 1,
    makes: { action: "conditional_execution" },
    icon: "split",
    previousStatement: null,
    nextStatement: null,
    args0: [{ type: "input_value", name: "CONDITION", check: "Boolean" }],
    message1: "%1",
    args1: [{ type: "input_statement", name: "THEN" }],
    mutator: "pinel_branches",
  },
  {
    ...logicValue,
    type: "compare",
    level: 1,
    makes: { op: COMPARISONS },
    args0: [
      side("A"),
      dropdown("OPERATOR", [
        ["=", "=="],
        ["≠", "!="],
        ["<", "<"],
        ["≤", "<="],
        [">", ">"],
        ["≥", ">="],
      ]),
      side("B"),
    ],
  },
  {
    ...logicValue,
    type: "logic_operation",
    level: 2,
    makes: { op: ["and", "or"] },
    args0: [
      side("A", "Boolean"),
      dropdown("OPERATOR", [
        ["%{BKY_PINEL_AND}", "and"],
        ["%{BKY_PINEL_OR}", "or"],
      ]),
      side("B", "Boolean"),
    ],
    variadic: { check: "Boolean", min: 2, start: 2, shadow: null },
    mutator: "pinel_variadic",
  },
  {
    ...logicValue,
    ...operation("not"),
    level: 2,
    args0: [side("A", "Boolean")],
  },
  {
    type: "boolean",
    style: "logic",
    level: 2,
    makes: { expression: "literal" },
    output: BOOLEAN_LITERAL,
    args0: [
      dropdown("BOOL", [
        ["%{BKY_PINEL_TRUE}", "TRUE"],
        ["%{BKY_PINEL_FALSE}", "FALSE"],
      ]),
    ],
  },
] as const satisfies readonly BlockDefinition[];
