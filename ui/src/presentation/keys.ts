import { listen } from "../kit/listen";

export type Action = "next" | "previous" | "play" | "names" | "solid" | "black" | "help" | "leave";

/** What a presentation of runs does, in the order of the help. */
export const RUN_ACTIONS: readonly Action[] = [
  "next",
  "previous",
  "play",
  "names",
  "solid",
  "black",
  "help",
  "leave",
];
/** What the presentation of a program does: it has no floor. */
export const PROGRAM_ACTIONS = RUN_ACTIONS.filter((one) => one !== "play" && one !== "solid");

/** Keys of keyboards and of presenters' remotes, which send Page Up, Page Down, F5, B or a full stop, and Escape. */
const ACTIONS: Readonly<Record<string, Action>> = {
  PageDown: "next",
  ArrowRight: "next",
  ArrowDown: "next",
  " ": "next",
  PageUp: "previous",
  ArrowLeft: "previous",
  ArrowUp: "previous",
  F5: "play",
  Enter: "play",
  p: "play",
  n: "names",
  "3": "solid",
  b: "black",
  ".": "black",
  "?": "help",
  Escape: "leave",
};

/** The action of a key; null if the focused element uses it, or if it has none. */
export function actionOf({ key, ctrlKey, altKey, metaKey, target }: KeyboardEvent): Action | null {
  if (ctrlKey || altKey || metaKey) return null;
  const focused = target instanceof Element ? target : null;
  if ((key === " " || key === "Enter") && focused?.closest("button, a, input")) return null;
  // arrow keys turn the floor in 3D and choose its camera
  if (key.startsWith("Arrow") && focused?.closest("[data-testid=scene-3d], .scene__cameras"))
    return null;
  return ACTIONS[key.length === 1 ? key.toLowerCase() : key] ?? null;
}

/** Handles keys before any other element does. Returns the unsubscribe function. */
export function listenToKeys(act: (action: Action) => void): () => void {
  const keydown = (event: KeyboardEvent) => {
    const action = actionOf(event);
    if (!action) return;
    event.preventDefault();
    event.stopPropagation();
    act(action);
  };
  return listen(window, { keydown }, { capture: true });
}
