import { options } from "preact";
import { listen } from "../../../kit/listen";
import { hideTip } from "../marks/tip";

/** The width of a line on A4 beside the name of its group, in pixels, as in print.css. */
export const PAPER_PX = 556;

/** False in the web views of some systems. */
export const canPrint = () => typeof window.print === "function";

export function printPage(): void {
  hideTip();
  window.print();
}

/** Draws for paper before the page is printed, and for the screen again afterwards. */
export function forPaper(draw: () => void, drawBack: () => void): () => void {
  return listen(window, {
    beforeprint: () => atOnce(draw),
    afterprint: () => atOnce(drawBack),
  });
}

/** The page is printed as it is when the event handler returns, so rendering cannot wait for the next frame. */
function atOnce(change: () => void): void {
  const { debounceRendering } = options;
  options.debounceRendering = (draw) => draw();
  change();
  if (debounceRendering) options.debounceRendering = debounceRendering;
  else delete options.debounceRendering;
}
