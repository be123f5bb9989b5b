import { options } from "preact";
import { listen } from "../../../kit/listen";
import { printPage } from "../../../shell/files/printing";
import { hideTip } from "../timeline_entries/tip";

/** Width of a timeline on A4 beside the name of its group, in pixels, as in print.css. */
export const PRINT_TIMELINE_PX = 556;

/** Prints the review without an open tooltip. */
export function printReview(): Promise<void> {
  hideTip();
  return printPage();
}

/** Draws for print before the page is printed, and for the screen again afterwards. */
export function forPrint(draw: () => void, drawBack: () => void): () => void {
  return listen(window, {
    beforeprint: () => atOnce(draw),
    afterprint: () => atOnce(drawBack),
  });
}

/** Renders synchronously: the page is printed as it is when the event handler returns. */
function atOnce(change: () => void): void {
  const { debounceRendering } = options;
  options.debounceRendering = (draw) => draw();
  change();
  if (debounceRendering) options.debounceRendering = debounceRendering;
  else delete options.debounceRendering;
}
