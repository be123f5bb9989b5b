import { signal } from "@preact/signals";

/** Words beside something that is pointed at, focused or tapped. */
export interface Tip {
  readonly title: string;
  readonly lines: readonly string[];
  /** What it is about, on the screen. */
  readonly anchor: Element;
}

/** What the tip says now: asked again when what it reads changes. */
type Saying = () => Omit<Tip, "anchor">;

export const tip = signal<{ anchor: Element; say: Saying } | null>(null);

export const TIP_ID = "review-tip";

export function showTip(anchor: Element, say: Saying): void {
  tip.value = { anchor, say };
}

export function hideTip(anchor?: Element): void {
  if (!anchor || tip.peek()?.anchor === anchor) tip.value = null;
}

export const isTipOf = (anchor: Element) => tip.peek()?.anchor === anchor;
