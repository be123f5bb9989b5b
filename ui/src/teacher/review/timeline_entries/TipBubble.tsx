import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import { listen } from "../../../kit/listen";
import { hideTip, TIP_ID, tip } from "./tip";

const GAP_PX = 8;
const EDGE_PX = 8;

/** The page's single tooltip. Escape and scrolling close it. */
export function TipBubble() {
  const bubble = useRef<HTMLDivElement>(null);
  const now = tip.value;
  useEffect(() => {
    const keys = listen(window, { keydown: ({ key }) => key === "Escape" && hideTip() });
    const scrolls = listen(window, { scroll: () => hideTip() }, { capture: true, passive: true });
    return () => {
      keys();
      scrolls();
      hideTip();
    };
  }, []);
  const text = now?.describe();
  useLayoutEffect(() => {
    if (bubble.current && now) place(bubble.current, now.anchor.getBoundingClientRect());
  });
  if (!text) return null;
  return (
    <div class="tip" role="tooltip" id={TIP_ID} ref={bubble}>
      <strong>{text.title}</strong>
      {text.lines.map((line) => (
        <p key={line}>{line}</p>
      ))}
    </div>
  );
}

/** Places the tooltip above the anchor, or below if there is not enough space. */
function place(bubble: HTMLElement, anchor: DOMRect): void {
  const { width, height } = bubble.getBoundingClientRect();
  const middle = anchor.left + anchor.width / 2 - width / 2;
  const left = Math.max(EDGE_PX, Math.min(middle, window.innerWidth - width - EDGE_PX));
  const above = anchor.top - height - GAP_PX;
  bubble.style.left = `${left}px`;
  bubble.style.top = `${above >= EDGE_PX ? above : anchor.bottom + GAP_PX}px`;
}
