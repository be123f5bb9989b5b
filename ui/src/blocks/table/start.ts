import type { BlockDefinition } from "../definition";

/** The start block, which every program has once; the blocks below it run. */
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
