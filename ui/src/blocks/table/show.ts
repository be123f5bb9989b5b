import type { BlockDefinition } from "../definition";
import { choice, colourOptions, command, nameField, textInput } from "./arguments";

const statement = { style: "show", previousStatement: null, nextStatement: null } as const;

export const show = [
  {
    ...statement,
    ...command("say"),
    level: 1,
    icon: "message",
    args0: [textInput("TEXT", "text", "HELLO")],
  },
  { ...statement, ...command("beep"), level: 1, icon: "volume", args0: [] },
  {
    ...statement,
    type: "pen_down",
    level: 1,
    makes: { action: "pen", fixed: { down: true } },
    icon: "penDown",
    args0: [choice("COLOR", "color", [...colourOptions, ["%{BKY_PINEL_COLOUR_SAME}", ""]])],
  },
  {
    ...statement,
    type: "pen_up",
    level: 1,
    makes: { action: "pen", fixed: { down: false } },
    icon: "penUp",
    args0: [choice("COLOR", "color", [["", ""], ...colourOptions])],
    extensions: ["quiet_colour"],
  },
  {
    ...statement,
    ...command("mark"),
    level: 2,
    icon: "crosshair",
    args0: [
      choice("SYMBOL", "symbol", [
        ["X", "X"],
        ["O", "O"],
      ]),
    ],
  },
  {
    ...statement,
    type: "mark_value",
    level: 3,
    makes: { action: "mark" },
    icon: "crosshair",
    args0: [
      {
        type: "input_value",
        name: "SYMBOL",
        key: "symbol",
        check: "String",
        shadow: { textKey: "SYMBOL" },
      },
    ],
  },
  {
    ...statement,
    ...command("ask"),
    level: 2,
    icon: "question",
    args0: [
      {
        type: "input_value",
        name: "QUESTION",
        key: "question",
        check: "String",
        shadow: { textKey: "QUESTION" },
      },
      nameField("VARIABLE", "variable"),
    ],
  },
] as const satisfies readonly BlockDefinition[];
