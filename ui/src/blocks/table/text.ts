import type { BlockDefinition } from "../definition";
import { operation, TEXT_LITERAL } from "./arguments";

export const text = [
  {
    type: "text",
    style: "text",
    level: 2,
    makes: { expression: "literal" },
    args0: [{ type: "field_input", name: "TEXT", text: "", spellcheck: false }],
    output: TEXT_LITERAL,
  },
  {
    ...operation("join"),
    style: "text",
    level: 2,
    args0: [],
    output: "String",
    variadic: { check: null, min: 1, start: 2, shadow: { textKey: "WORD" } },
    mutator: "pinel_variadic",
  },
] as const satisfies readonly BlockDefinition[];
