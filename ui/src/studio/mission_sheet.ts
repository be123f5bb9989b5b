import { effect, type ReadonlySignal, type Signal, signal } from "@preact/signals";
import { judged } from "../shell/session";
import { hasCommands, type OpenProgram } from "./program/open_program";

/** Whether the whole mission is shown over the program: until the group begins, and after a pass. */
export class MissionSheet {
  readonly isOpen: Signal<boolean>;

  /** `mine` tells whether the last run is one of this program. */
  constructor(
    private readonly open: OpenProgram,
    private readonly mine: ReadonlySignal<boolean>,
  ) {
    const { version } = open.program;
    // the editor has saved nothing yet: the blocks are those that the activity begins with
    const isUntouched = "document" in (version?.workspace ?? {});
    this.isOpen = signal(isUntouched || !hasCommands(version?.document));
  }

  /** Whoever touches the program or runs it works on: the sheet no longer covers the blocks. */
  close(): void {
    this.isOpen.value = false;
  }

  /** Opens the sheet after each pass from now on. Returns the function that ends this. */
  openAfterPasses(): () => void {
    const known = judged.peek();
    return effect(() => {
      const { value: verdict } = judged;
      if (verdict === known || !verdict?.passed || !this.mine.peek()) return;
      const { activity } = this.open.setup.peek();
      if (activity) this.open.addPassed(activity);
      this.isOpen.value = true;
    });
  }
}
