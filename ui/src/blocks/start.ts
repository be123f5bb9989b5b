import type { BlockDefinition } from "./definition";
import { iconArgument } from "./icons";

/** The one block every program has; what hangs below it runs. */
export const start = [
  {
    type: "program_start",
    style: "start",
    args0: [iconArgument("play")],
    nextStatement: null,
    hat: "cap",
  },
] as const satisfies readonly BlockDefinition[];
