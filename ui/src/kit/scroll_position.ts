import type { RefObject } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";

/** Scroll position of a page, in pixels. */
export interface ScrollPosition {
  top: number;
}

/** Restores the scroll position of an element after it is drawn, and then records it. */
export function useScrollPosition(
  position: ScrollPosition,
  isDrawn: boolean,
): RefObject<HTMLElement> {
  const element = useRef<HTMLElement>(null);
  useLayoutEffect(() => {
    const { current: scrolled } = element;
    if (!isDrawn || !scrolled) return;
    const initialTop = position.top;
    const recordTop = () => {
      position.top = scrolled.scrollTop;
    };
    // line heights are final only after the first layout
    const frame = requestAnimationFrame(() => {
      scrolled.scrollTop = initialTop;
      scrolled.addEventListener("scroll", recordTop);
    });
    return () => {
      cancelAnimationFrame(frame);
      scrolled.removeEventListener("scroll", recordTop);
    };
  }, [position, isDrawn]);
  return element;
}
