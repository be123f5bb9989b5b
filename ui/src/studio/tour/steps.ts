/** The steps of the guided first drive, in order. */
export const STEPS = ["hello", "move", "run", "watch", "turn", "again", "end"] as const;

export type TourStep = (typeof STEPS)[number];

/** The steps in a mission: its program gets no more than the first move. */
export const MISSION_STEPS: readonly TourStep[] = ["hello", "move", "run", "watch", "end"];

/** The pupils' progress so far, as far as the studio knows it. */
export interface StudioState {
  /** Actions of the commands directly under the start block, in order. */
  readonly actions: readonly string[];
  /** The last run of the program; null before the first. */
  readonly run: string | null;
  readonly isRunning: boolean;
}

export interface Progress {
  readonly step: TourStep;
  /** Whether the pupils added another block than the step asked for. */
  readonly isOther: boolean;
  /** The commands at the start of the step, and the last run before the run that the step asks for. */
  readonly since: Pick<StudioState, "actions" | "run">;
}

/**
 * Progress at the start of the tour, or at the stored step after a reload of the page. A reload
 * ends the step `watch`, so the run is repeated.
 */
export const beginning = ({ actions, run }: StudioState, step: TourStep = "hello"): Progress => ({
  step: step === "watch" ? "run" : step,
  isOther: false,
  since: { actions, run },
});

export const isStep = (name: string | null): name is TourStep =>
  STEPS.some((step) => step === name);

/** The command that a step asks for. */
const EXPECTED_ACTIONS: Partial<Record<TourStep, string>> = { move: "move_forward", turn: "turn" };

/** The commands of `now` that are not in `before`. */
function put(before: readonly string[], now: readonly string[]): string[] {
  const left = [...before];
  return now.filter((action) => {
    const at = left.indexOf(action);
    if (at >= 0) left.splice(at, 1);
    return at < 0;
  });
}

/** Progress at the next of the steps; the last step follows itself. */
export function after(
  { step, since, isOther }: Progress,
  { actions, run }: StudioState,
  steps: readonly TourStep[] = STEPS,
): Progress {
  const expected = EXPECTED_ACTIONS[step];
  return {
    step: steps[steps.indexOf(step) + 1] ?? "end",
    // a remark about the other block also applies to the step of its run
    isOther: expected ? !put(since.actions, actions).includes(expected) : step === "run" && isOther,
    since: {
      actions: step === "hello" ? since.actions : actions,
      run: step === "watch" ? run : since.run,
    },
  };
}

/** Progress in a state of the studio: skips each step that is done, by whatever means. */
export function advanced(
  progress: Progress,
  state: StudioState,
  steps: readonly TourStep[] = STEPS,
): Progress {
  return isDone(progress, state) ? advanced(after(progress, state, steps), state, steps) : progress;
}

function isDone({ step, since }: Progress, { actions, run, isRunning }: StudioState): boolean {
  const isNewRun = run !== null && run !== since.run;
  switch (step) {
    case "hello": // pupils who add a block need no greeting
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
