import type { BlockDefinition } from "../definition";
import {
  body,
  command,
  conditionInput,
  nameField,
  numberInput,
  SECONDS,
  TIMEOUT,
  TIMES,
} from "./arguments";

const statement = { style: "flow", previousStatement: null, nextStatement: null } as const;
const condition = conditionInput("CONDITION", "condition");

export const flow = [
  {
    ...statement,
    ...body,
    ...command("repeat"),
    level: 1,
    icon: "repeat",
    args0: [numberInput("TIMES", "times", 4, TIMES)],
  },
  {
    ...statement,
    ...command("wait"),
    level: 1,
    icon: "clock",
    args0: [numberInput("SECONDS", "seconds", 1, SECONDS)],
  },
  { ...statement, ...body, ...command("forever"), level: 2, icon: "infinity", args0: [] },
  { ...statement, ...body, ...command("while"), level: 2, icon: "refresh", args0: [condition] },
  { ...statement, ...body, ...command("until"), level: 2, icon: "refresh", args0: [condition] },
  { ...statement, ...command("wait_until"), level: 2, icon: "hourglass", args0: [condition] },
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
    ...command("for"),
    level: 2,
    icon: "hash",
    args0: [
      nameField("VARIABLE", "variable"),
      numberInput("FROM", "from", 1),
      numberInput("TO", "to", 10),
      numberInput("BY", "by", 1),
    ],
  },
  { ...statement, ...command("break"), level: 2, icon: "logOut", args0: [] },
  { ...statement, ...command("continue"), level: 3, icon: "skip", args0: [] },
] as const satisfies readonly BlockDefinition[];
