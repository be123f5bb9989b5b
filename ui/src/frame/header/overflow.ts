import type { RefObject } from "preact";
import { useLayoutEffect } from "preact/hooks";

/**
 * Parts that the header hides if it overflows, in this order; `data-short` lists the hidden ones.
 */
const LEFT_OUT = [
  "brand",
  "language",
  "album",
  "work",
  "help",
  "words",
  "albumLink",
  "robot",
  "lesson",
  "saved",
  "group",
] as const;

/** Hides parts of the header while its contents are too wide. Names are shortened last. */
export function useOverflow(header: RefObject<HTMLElement>): void {
  useLayoutEffect(() => {
    const { current: element } = header;
    if (!element) return;
    let frame = 0;
    // once per animation frame, because each measurement lays out the whole page
    const measure = () => {
      frame ||= requestAnimationFrame(() => {
        frame = 0;
        leaveOut(element);
      });
    };
    const sizes = new ResizeObserver(() => leaveOut(element));
    sizes.observe(element);
    const changes = new MutationObserver(measure);
    changes.observe(element, { childList: true, characterData: true, subtree: true });
    document.fonts?.addEventListener("loadingdone", measure); // a weight loads at first use
    return () => {
      cancelAnimationFrame(frame);
      sizes.disconnect();
      changes.disconnect();
      document.fonts?.removeEventListener("loadingdone", measure);
    };
  }, []);
}

/** Hides as few parts as needed. Meanwhile `data-measuring` gives every part its full width. */
function leaveOut(header: HTMLElement): void {
  header.dataset.measuring = "";
  for (let n = 0; n <= LEFT_OUT.length; n++) {
    header.dataset.short = LEFT_OUT.slice(0, n).join(" ");
    if (!isTooWide(header)) break;
  }
  delete header.dataset.measuring;
}

function isTooWide(header: HTMLElement): boolean {
  const end = header.lastElementChild?.getBoundingClientRect().right ?? 0;
  const room =
    header.getBoundingClientRect().right - parseFloat(getComputedStyle(header).paddingRight);
  return end > room + 1;
}
