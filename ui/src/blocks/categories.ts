/**
 * One hue per block category. Workspace, help and the time slider of a replay use the same hue, so
 * no other file repeats these values. White text is legible on every hue.
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
