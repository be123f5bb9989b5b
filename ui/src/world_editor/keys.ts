import type { EditorStore } from "./editor_store";
import { FINE, GRID } from "./geometry";

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** Handles a key while the board has focus; returns true if the key has a function. */
export function pressed(store: EditorStore, event: KeyboardEvent): boolean {
  const arrow = ARROWS[event.key];
  if (arrow && store.selected.value) {
    const step = event.shiftKey ? FINE : GRID;
    store.nudge(arrow[0] * step, arrow[1] * step);
    return true;
  }
  switch (event.key) {
    case "Delete":
    case "Backspace":
      store.remove();
      return true;
    case "Enter":
      if (store.tool.value === "select") return false;
      store.putDown({ x: 0, y: 0 });
      return true;
    default:
      return false;
  }
}

/** Handles keys that work anywhere in the editor. */
export function pressedAnywhere(store: EditorStore, event: KeyboardEvent): boolean {
  const key = event.key.toLowerCase();
  const isCommand = event.ctrlKey || event.metaKey;
  if (isCommand && key === "z" && !event.shiftKey) store.undo();
  else if (isCommand && (key === "y" || (key === "z" && event.shiftKey))) store.redo();
  else if (isCommand && key === "d") store.double();
  else if (event.key === "Escape") leave(store);
  else return false;
  return true;
}

function leave(store: EditorStore): void {
  if (store.isGripping) store.cancel();
  else if (store.tool.value !== "select") store.choose("select");
  else store.select(null);
}
