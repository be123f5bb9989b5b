/**
 * One hue per block category. The same hue marks the category in the workspace, in the time slider of a
 * replay and in help, so this table is the only place where it is written down. White text is legible on all.
 */
export const CATEGORY_COLOURS = {
  motion: "#2b67b8",
  flow: "#ad5c08",
  logic: "#6a55c4",
  gestures: "#a8327f",
} as const;

export type Category = keyof typeof CATEGORY_COLOURS;

const CATEGORY_OF_ACTION: Record<string, Category> = {
  move_forward: "motion",
  move_backward: "motion",
  turn: "motion",
  stop: "motion",
  repeat: "flow",
  wait: "flow",
  conditional_execution: "logic",
  classify_gestures: "gestures",
  set_gesture_result: "gestures",
};

/** The category of an action of the program document. */
export function categoryOf(action: string): Category {
  return CATEGORY_OF_ACTION[action] ?? "flow";
}
