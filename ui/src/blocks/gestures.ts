import type { BlockDefinition } from "./definition";
import { iconArgument } from "./icons";

const statement = { style: "gestures", previousStatement: null, nextStatement: null } as const;

export const gestures = [
  {
    ...statement,
    type: "classify_gestures",
    args0: [
      iconArgument("hand"),
      { type: "field_measure", name: "TIMEOUT", value: 10, min: 1, max: 60, precision: 1 },
    ],
  },
  { type: "gesture_result", style: "gestures", args0: [], output: "Text" },
  {
    type: "text_letter",
    style: "gestures",
    args0: [{ type: "field_input", name: "TEXT", text: "B", spellcheck: false }],
    output: "Text",
  },
  {
    ...statement,
    type: "set_gesture_result",
    args0: [
      iconArgument("pencil"),
      { type: "field_input", name: "RESULT", text: "B", spellcheck: false },
    ],
  },
] as const satisfies readonly BlockDefinition[];
