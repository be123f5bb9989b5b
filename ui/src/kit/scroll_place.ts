import type { RefObject } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";

/** How far down a page was left. */
export interface ScrollPlace {
  top: number;
}

/** Scrolls an element to where it was left, once it is drawn, and remembers where it is left the next time. */
export function useScrollPlace(place: ScrollPlace, isDrawn: boolean): RefObject<HTMLElement> {
  const element = useRef<HTMLElement>(null);
  useLayoutEffect(() => {
    const { current: scrolled } = element;
    if (!isDrawn || !scrolled) return;
    const wanted = place.top;
    const remember = () => {
      place.top = scrolled.scrollTop;
    };
    // lines are as high as they will be when their width was measured
    const frame = requestAnimationFrame(() => {
      scrolled.scrollTop = wanted;
      scrolled.addEventListener("scroll", remember);
    });
    return () => {
      cancelAnimationFrame(frame);
      scrolled.removeEventListener("scroll", remember);
    };
  }, [place, isDrawn]);
  return element;
}
