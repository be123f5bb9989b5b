import { signal } from "@preact/signals";
import { choose, setting } from "../shell/settings";

/** Width of the blocks, as a percentage of the studio. */
export const DEFAULT_PART = 58;
/** The same in a window in which neither pane has the width that it needs. */
const NARROW_PART = 50;

/** Widths that the panes need at least; pixels. */
const BLOCKS_PX = 420;
const FLOOR_PX = 360;

const stored = setting("pinel_split");

/** Width of the blocks now, as a percentage of the studio, also while the line is dragged. */
export const blocksPart = signal(Number(stored.peek()) || DEFAULT_PART);

/** The nearest percentage with which both panes have the width that they need; in a narrow window, half. */
export function clampedPart(part: number, width: number): number {
  const least = (BLOCKS_PX / width) * 100;
  const most = 100 - (FLOOR_PX / width) * 100;
  return least > most ? NARROW_PART : Math.min(most, Math.max(least, part));
}

/** `blocksPart` within what this window allows: another window, or another screen, may have stored it. */
export function shownPart(): number {
  return clampedPart(blocksPart.value, windowWidth.value);
}

const windowWidth = signal(innerWidth);
addEventListener("resize", () => {
  windowWidth.value = innerWidth;
});

/** Moves the line and stores its place on this PC. */
export function setBlocksPart(part: number): void {
  blocksPart.value = part;
  void choose("pinel_split", part === DEFAULT_PART ? "" : String(Math.round(part)));
}
