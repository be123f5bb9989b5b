/**
 * One hue per block category. The same hue marks the category in the workspace, in the time slider of a
 * replay and in help, so this table is the only place where it is written down. White text is legible on all.
 */
export const CATEGORY_COLOURS = {
  motion: "#2b67b8",
  flow: "#ad5c08",
  logic: "#6a55c4",
  gestures: "#a8327f",
  sensing: "#0b7480",
  show: "#8a3fb0",
  variables: "#806000",
  maths: "#24793c",
  text: "#566a86",
  lists: "#5c6f14",
  functions: "#7d5538",
} as const;

export type Category = keyof typeof CATEGORY_COLOURS;

const ACTIONS: Readonly<Record<Category, readonly string[]>> = {
  motion: ["move_forward", "move_backward", "turn", "stop", "drive", "arc", "set_speed", "go_to"],
  flow: ["repeat", "while", "until", "for", "forever", "break", "continue", "wait", "wait_until"],
  logic: ["conditional_execution"],
  gestures: ["classify_gestures", "set_gesture_result"],
  sensing: [],
  show: ["say", "mark", "pen", "beep", "ask"],
  variables: ["set_variable", "change_variable"],
  maths: [],
  text: [],
  lists: ["append"],
  functions: ["call", "return"],
};

const CATEGORY_OF_ACTION = new Map(
  Object.entries(ACTIONS).flatMap(([category, actions]) =>
    actions.map((action) => [action, category as Category] as const),
  ),
);

/** The category of an action of the program document. */
export function categoryOf(action: string): Category {
  return CATEGORY_OF_ACTION.get(action) ?? "flow";
}
