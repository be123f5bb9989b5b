import { effect, type ReadonlySignal } from "@preact/signals";
import type { DialogueLine } from "./output";
import { isLivePhase, type RunView } from "./reducer";

/** Robot time for which a text is shown, in ticks, unless another text follows. */
export const TEXT_TICKS = 120;
/** Minimum real time, at any speed of the run, in ms. */
export const MIN_TEXT_MS = 1200;
/** Real time for which the last text of a run is shown: after the run, robot time stands still. */
export const AFTER_RUN_MS = 4000;

/**
 * Calls `show` with the text that the robot says now, null for none. Returns the function that ends the calls.
 *
 * @param isStill - whether the view shows one tick of a recorded run. A text of such a tick is shown as long as the tick
 * is. Tracked as a signal.
 */
export function showText(
  view: ReadonlySignal<RunView>,
  isStill: () => boolean,
  show: (text: DialogueLine["text"] | null) => void,
): () => void {
  const signs = new TextSign(() => show(signs.textOf(view.peek(), isStill())));
  const stop = effect(() => show(signs.textOf(view.value, isStill())));
  return () => {
    stop();
    signs.dispose();
  };
}

/** The text that the robot said shortly before the tick of a view, in robot time; null for none. */
export function recentText({ output, tick }: RunView): DialogueLine["text"] | null {
  const line = output.talk.findLast(({ kind }) => kind === "said");
  return line && tick - line.tick < TEXT_TICKS ? line.text : null;
}

/** Knows which text is shown for its minimum time, and which one after the end of its run. */
class TextSign {
  private run: string | null = null;
  private newest = -1;
  /** Number of the line that is shown for its minimum time; -1 for none. */
  private fresh = -1;
  /** Number of the last line of a run that is over, as soon as its time is over. */
  private hidden = -1;
  private readonly timers: { fresh?: Timer | undefined; hidden?: Timer | undefined } = {};

  constructor(private readonly changed: () => void) {}

  textOf(view: RunView, still: boolean): DialogueLine["text"] | null {
    const line = view.output.talk.findLast(({ kind }) => kind === "said") ?? null;
    const isOver = !isLivePhase(view.phase);
    const number = line?.number ?? -1;
    if (view.run !== this.run) this.begin(view.run, isOver && !still ? number : -1, number);
    if (!line) return null;
    const isRecent = view.tick - line.tick < TEXT_TICKS;
    if (still) return recentText(view);
    if (number !== this.newest) this.setNewest(number, isRecent);
    if (isOver && isRecent) this.hideSoon(number);
    if (isOver && this.hidden === number) return null;
    return isRecent || this.fresh === number ? line.text : null;
  }

  dispose(): void {
    clearTimeout(this.timers.fresh);
    clearTimeout(this.timers.hidden);
  }

  /** The texts of a run that was over before it was shown are not shown. */
  private begin(run: string | null, hidden: number, newest: number): void {
    this.dispose();
    Object.assign(this, { run, hidden, newest, fresh: -1 });
    this.timers.hidden = undefined;
  }

  private setNewest(number: number, isRecent: boolean): void {
    this.dispose();
    this.timers.hidden = undefined;
    this.newest = number;
    this.fresh = isRecent ? number : -1;
    this.timers.fresh = setTimeout(() => {
      this.fresh = -1;
      this.changed();
    }, MIN_TEXT_MS);
  }

  private hideSoon(number: number): void {
    if (this.hidden === number) return;
    this.timers.hidden ??= setTimeout(() => {
      this.hidden = number;
      this.changed();
    }, AFTER_RUN_MS);
  }
}

type Timer = ReturnType<typeof setTimeout>;
