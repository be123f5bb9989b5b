import type { BlockDefinition } from "../definition";

/** The one block every program has; what hangs below it runs. */
export const start = [
  {
    type: "program_start",
    style: "start",
    level: 1,
    makes: null,
    icon: "play",
    args0: [],
    nextStatement: null,
    hat: "cap",
  },
] as const satisfies readonly BlockDefinition[];
