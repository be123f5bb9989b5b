import type { RefObject } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";

/** Scroll position of a page, in pixels. */
export interface ScrollPlace {
  top: number;
}

/** Restores the scroll position of an element once it is drawn, and stores it afterwards. */
export function useScrollPlace(place: ScrollPlace, isDrawn: boolean): RefObject<HTMLElement> {
  const element = useRef<HTMLElement>(null);
  useLayoutEffect(() => {
    const { current: scrolled } = element;
    if (!isDrawn || !scrolled) return;
    const wanted = place.top;
    const remember = () => {
      place.top = scrolled.scrollTop;
    };
    // line heights are final only after the first layout
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
