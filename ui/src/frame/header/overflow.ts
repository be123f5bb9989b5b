import type { RefObject } from "preact";
import { useLayoutEffect } from "preact/hooks";

/** What the header leaves out where it has no room, in this order: `data-short` names each. */
const LEFT_OUT = ["brand", "language", "work", "help", "words", "robot", "lesson"] as const;

/** Leaves words out of the header while its contents are wider than it: names are shortened last. */
export function useOverflow(header: RefObject<HTMLElement>): void {
  useLayoutEffect(() => {
    const { current: element } = header;
    if (!element) return;
    let frame = 0;
    // once before the next drawing, whatever changes until then: measuring lays out the whole page
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
    document.fonts?.addEventListener("loadingdone", measure); // each weight comes when it is first used
    return () => {
      cancelAnimationFrame(frame);
      sizes.disconnect();
      changes.disconnect();
      document.fonts?.removeEventListener("loadingdone", measure);
    };
  }, []);
}

/** `data-measuring` gives every part its whole width meanwhile. */
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
