/** The steps of the guided first drive, in order. */
export const STEPS = ["hello", "move", "run", "watch", "turn", "again", "end"] as const;

export type Step = (typeof STEPS)[number];

/** What a pupil has done so far, as the studio knows it. */
export interface StudioState {
  /** Actions of the commands directly under the start block, in order. */
  readonly actions: readonly string[];
  /** The last run of the program; null before the first. */
  readonly run: string | null;
  readonly isRunning: boolean;
}

export interface Progress {
  readonly step: Step;
  /** Another block was put than the one that the step named. */
  readonly isOther: boolean;
  /** The blocks as the step began, and the run before the one that the step is about. */
  readonly since: Pick<StudioState, "actions" | "run">;
}

/** Begins at a step, the first one or that of a page that was loaded again: a run that nobody sees is repeated. */
export const beginning = ({ actions, run }: StudioState, step: Step = "hello"): Progress => ({
  step: step === "watch" ? "run" : step,
  isOther: false,
  since: { actions, run },
});

export const isStep = (name: string | null): name is Step => STEPS.some((step) => step === name);

/** The block that a step asks for. */
const EXPECTED_ACTIONS: Partial<Record<Step, string>> = { move: "move_forward", turn: "turn" };

/** The commands that are there now and were not before. */
function put(before: readonly string[], now: readonly string[]): string[] {
  const left = [...before];
  return now.filter((action) => {
    const at = left.indexOf(action);
    if (at >= 0) left.splice(at, 1);
    return at < 0;
  });
}

/** The next step; of the last one the last. */
export function after({ step, since, isOther }: Progress, { actions, run }: StudioState): Progress {
  const expected = EXPECTED_ACTIONS[step];
  return {
    step: STEPS[STEPS.indexOf(step) + 1] ?? "end",
    // what was said of the block holds for its run
    isOther: expected ? !put(since.actions, actions).includes(expected) : step === "run" && isOther,
    since: {
      actions: step === "hello" ? since.actions : actions,
      run: step === "watch" ? run : since.run,
    },
  };
}

/** Where the pupils are after what they have done: a step is over once it is done, however it was done. */
export function advanced(progress: Progress, state: StudioState): Progress {
  return isDone(progress, state) ? advanced(after(progress, state), state) : progress;
}

function isDone({ step, since }: Progress, { actions, run, isRunning }: StudioState): boolean {
  const isNewRun = run !== null && run !== since.run;
  switch (step) {
    case "hello": // whoever takes a block needs no greeting
    case "move":
    case "turn":
      return put(since.actions, actions).length > 0;
    case "run":
      return isNewRun;
    case "watch":
    case "again":
      return isNewRun && !isRunning;
    default:
      return false;
  }
}
