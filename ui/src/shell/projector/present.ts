import { projectorApi } from "../../api/projector";
import { go, type Route } from "../route";

/** A presentation: of a run, of two side by side, or of a program. */
export type Presentation = Extract<Route, { screen: "presentation" | "presentedprogram" }>;

/** Whether this page has opened the presentation that it shows, so that going back leads to where it was opened. */
let isOpenedHere = false;

/** Presents a run, or two side by side: on a second screen, if the PC has one, else in this window. */
export async function presentRuns(first: string, second: string | null): Promise<void> {
  const runs = second === null ? [first] : [first, second];
  if (await projectorApi.present({ runs })) return;
  open({ screen: "presentation", window: "same", first, second });
}

/** Presents the blocks of a program in the same way. */
export async function presentProgram(program: string): Promise<void> {
  if (await projectorApi.present({ program })) return;
  open({ screen: "presentedprogram", window: "same", program });
}

function open(presentation: Presentation): void {
  isOpenedHere = true;
  go(presentation);
}

/** Ends a presentation: closes the second window, or returns to the screen from which it was opened. */
export async function leave(shown: Presentation): Promise<void> {
  if (shown.window === "second") await projectorApi.end();
  else if (isOpenedHere) history.back();
  else go(withoutProjector(shown));
}

/** The screen that shows the same without a projector. */
function withoutProjector(shown: Presentation): Route {
  if (shown.screen === "presentedprogram") return { screen: "studio", program: shown.program };
  const { first, second } = shown;
  if (second === null) return { screen: "replay", run: first };
  return { screen: "compare", first, second };
}
