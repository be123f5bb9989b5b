import type { BlockType } from "../../blocks/definitions";

/** Tasks of pupils, each with its blocks and its examples; the texts are in `texts.help.tasks`. */
export const TASKS = {
  drive: { blocks: ["move_forward", "turn", "arc", "go_to"], examples: ["spiral", "dice"] },
  draw: { blocks: ["pen_down", "pen_up", "mark"], examples: ["flower_of_arcs", "snowflake"] },
  sense: {
    blocks: ["distance_sensor", "floor", "bumper"],
    examples: ["vacuum_cleaner", "line_follower"],
  },
  decide: {
    blocks: ["if", "classify_gestures", "read_number", "ask"],
    examples: ["dance_of_signs", "guessing_game"],
  },
  repeat: { blocks: ["repeat", "forever", "until"], examples: ["snail", "shy"] },
} as const satisfies Record<string, { blocks: readonly BlockType[]; examples: readonly string[] }>;

export type TaskName = keyof typeof TASKS;

export const TASK_NAMES = Object.keys(TASKS) as TaskName[];
