import type { BlockDefinition } from "../definition";
import { body, conditionInput, nameField, numberInput, SECONDS, TIMEOUT, TIMES } from "./arguments";

const statement = { style: "flow", previousStatement: null, nextStatement: null } as const;
const condition = conditionInput("CONDITION", "condition");

export const flow = [
  {
    ...statement,
    ...body,
    type: "repeat",
    level: 1,
    makes: { action: "repeat" },
    icon: "repeat",
    args0: [numberInput("TIMES", "times", 4, TIMES)],
  },
  {
    ...statement,
    type: "wait",
    level: 1,
    makes: { action: "wait" },
    icon: "clock",
    args0: [numberInput("SECONDS", "seconds", 1, SECONDS)],
  },
  {
    ...statement,
    ...body,
    type: "forever",
    level: 2,
    makes: { action: "forever" },
    icon: "infinity",
    args0: [],
  },
  {
    ...statement,
    ...body,
    type: "while",
    level: 2,
    makes: { action: "while" },
    icon: "refresh",
    args0: [condition],
  },
  {
    ...statement,
    ...body,
    type: "until",
    level: 2,
    makes: { action: "until" },
    icon: "refresh",
    args0: [condition],
  },
  {
    ...statement,
    type: "wait_until",
    level: 2,
    makes: { action: "wait_until" },
    icon: "hourglass",
    args0: [condition],
  },
  {
    ...statement,
    type: "wait_until_timeout",
    level: 3,
    makes: { action: "wait_until" },
    icon: "hourglass",
    args0: [condition, numberInput("TIMEOUT", "timeout", 10, TIMEOUT)],
  },
  {
    ...statement,
    ...body,
    type: "for",
    level: 2,
    makes: { action: "for" },
    icon: "hash",
    args0: [
      nameField("VARIABLE", "variable"),
      numberInput("FROM", "from", 1),
      numberInput("TO", "to", 10),
      numberInput("BY", "by", 1),
    ],
  },
  {
    ...statement,
    type: "break",
    level: 2,
    makes: { action: "break" },
    icon: "logOut",
    args0: [],
  },
  {
    ...statement,
    type: "continue",
    level: 3,
    makes: { action: "continue" },
    icon: "skip",
    args0: [],
  },
] as const satisfies readonly BlockDefinition[];
