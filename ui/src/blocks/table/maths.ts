import type { BlockDefinition } from "../definition";
import { dropdown, NUMBER_LITERAL, operation } from "./arguments";

const result = { style: "maths", output: "Number" } as const;
const operand = (name: string, start: number) =>
  ({ type: "input_value", name, check: "Number", shadow: { number: start } }) as const;

export const maths = [
  {
    type: "number",
    style: "maths",
    level: 2,
    makes: { expression: "literal" },
    args0: [{ type: "field_measure", name: "NUM", value: 0 }],
    output: NUMBER_LITERAL,
  },
  {
    ...result,
    type: "arithmetic",
    level: 2,
    makes: { op: ["+", "-", "*", "/", "**"] },
    args0: [
      operand("A", 1),
      dropdown("OPERATOR", [
        ["+", "+"],
        ["−", "-"],
        ["×", "*"],
        ["÷", "/"],
        ["^", "**"],
      ]),
      operand("B", 1),
    ],
  },
  {
    ...result,
    ...operation("random_int"),
    level: 2,
    args0: [operand("A", 1), operand("B", 6)],
  },
  {
    ...result,
    ...operation("remainder", "%"),
    level: 3,
    args0: [operand("A", 7), operand("B", 2)],
  },
  {
    ...result,
    type: "math_function",
    level: 3,
    makes: { op: ["round", "abs", "sqrt", "sin", "cos", "tan"] },
    args0: [
      dropdown(
        "OPERATOR",
        ["round", "abs", "sqrt", "sin", "cos", "tan"].map((op) => [
          `%{BKY_PINEL_MATH_${op.toUpperCase()}}`,
          op,
        ]),
      ),
      operand("A", 9),
    ],
  },
  {
    ...result,
    type: "min_max",
    level: 3,
    makes: { op: ["min", "max"] },
    args0: [
      dropdown("OPERATOR", [
        ["%{BKY_PINEL_MATH_MIN}", "min"],
        ["%{BKY_PINEL_MATH_MAX}", "max"],
      ]),
    ],
    variadic: { check: "Number", min: 1, start: 2, shadow: { number: 1 } },
    mutator: "pinel_variadic",
  },
] as const satisfies readonly BlockDefinition[];
