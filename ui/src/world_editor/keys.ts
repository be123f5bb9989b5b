import type { WorldDesk } from "./desk";
import { FINE, GRID } from "./geometry";

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** Does what a key says while the board has the focus; true where it says anything. */
export function pressed(desk: WorldDesk, event: KeyboardEvent): boolean {
  const arrow = ARROWS[event.key];
  if (arrow && desk.selected.value) {
    const step = event.shiftKey ? FINE : GRID;
    desk.nudge(arrow[0] * step, arrow[1] * step);
    return true;
  }
  switch (event.key) {
    case "Delete":
    case "Backspace":
      desk.remove();
      return true;
    case "Enter":
      if (desk.tool.value === "select") return false;
      desk.putDown({ x: 0, y: 0 });
      return true;
    default:
      return false;
  }
}

/** Keys that count all over the editor. */
export function pressedAnywhere(desk: WorldDesk, event: KeyboardEvent): boolean {
  const key = event.key.toLowerCase();
  const isCommand = event.ctrlKey || event.metaKey;
  if (isCommand && key === "z" && !event.shiftKey) desk.undo();
  else if (isCommand && (key === "y" || (key === "z" && event.shiftKey))) desk.redo();
  else if (isCommand && key === "d") desk.double();
  else if (event.key === "Escape") leave(desk);
  else return false;
  return true;
}

function leave(desk: WorldDesk): void {
  if (desk.isGripping) desk.cancel();
  else if (desk.tool.value !== "select") desk.choose("select");
  else desk.select(null);
}
