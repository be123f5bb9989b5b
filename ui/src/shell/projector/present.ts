import { projectorApi } from "../../api/projector";
import { go, type ParametersOf } from "../route";

/** Whether this page has opened the presentation that it shows, so that going back leads to where it was opened. */
let isOpenedHere = false;

/** Presents a run, or two side by side: on a second screen, if the PC has one, else in this window. */
export async function present(first: string, second: string | null): Promise<void> {
  const runs = second === null ? [first] : [first, second];
  if (await projectorApi.present(runs)) return;
  isOpenedHere = true;
  go({ screen: "presentation", window: "same", first, second });
}

/** Ends a presentation: closes the second window, or returns to the screen from which it was opened. */
export async function leave(shown: ParametersOf<"presentation">): Promise<void> {
  const { window: where, first, second } = shown;
  if (where === "second") await projectorApi.end();
  else if (isOpenedHere) history.back();
  else if (second === null) go({ screen: "replay", run: first });
  else go({ screen: "compare", first, second });
}
