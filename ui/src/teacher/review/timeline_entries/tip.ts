import { signal } from "@preact/signals";

/** Tooltip of an element that is hovered, focused or tapped. */
export interface Tip {
  readonly title: string;
  readonly lines: readonly string[];
  /** The described element. */
  readonly anchor: Element;
}

/** Returns the text; called again when a signal that it reads changes. */
type DescribeTip = () => Omit<Tip, "anchor">;

export const tip = signal<{ anchor: Element; describe: DescribeTip } | null>(null);

export const TIP_ID = "review-tip";

export function showTip(anchor: Element, describe: DescribeTip): void {
  tip.value = { anchor, describe };
}

export function hideTip(anchor?: Element): void {
  if (!anchor || tip.peek()?.anchor === anchor) tip.value = null;
}

export const isTipOf = (anchor: Element) => tip.peek()?.anchor === anchor;
