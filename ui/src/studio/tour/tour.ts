import { effect, signal } from "@preact/signals";
import * as robot from "../../run/live";
import { TOUR_OVER, tourFor, tourSteps } from "../../shell/help";
import { report } from "../../shell/session";
import type { StudioControl } from "../studio_control";
import {
  advanced,
  after,
  beginning,
  isStep,
  MISSION_STEPS,
  type Progress,
  STEPS,
  type StudioState,
  type TourStep,
} from "./steps";

/** After this time in a step, the tour offers to do the step for the pupils. */
const SHOW_AFTER_MS = 20_000;

/** State of the guided first drive in a studio: the pupils' progress, and the actions of the balloon. */
export class Tour {
  readonly progress = signal<Progress>(beginning({ actions: [], run: null, isRunning: false }));
  /** Whether the tour offers to do the step: the step has lasted `SHOW_AFTER_MS`. */
  readonly canShow = signal(false);
  /** Whether the program is for a mission. */
  readonly inMission: boolean;
  readonly steps: readonly TourStep[];
  private readonly stops: (() => void)[];
  private timer = 0;

  constructor(private readonly control: StudioControl) {
    this.inMission = control.open.mission.peek() !== null;
    this.steps = this.inMission ? MISSION_STEPS : STEPS;
    const storedStep = tourSteps.of(this.group);
    this.progress.value = beginning(this.studioState(), isStep(storedStep) ? storedStep : "hello");
    this.storeStep();
    this.stops = [
      effect(() => {
        const state = this.studioState();
        this.setProgress(advanced(this.progress.peek(), state, this.steps));
      }),
    ];
    this.wait();
  }

  /** Goes to the next step, from a step that asks for no action. */
  next(): void {
    this.setProgress(after(this.progress.peek(), this.studioState(), this.steps));
  }

  /** Performs the action of the step for the pupils. */
  show(): void {
    const { step } = this.progress.peek();
    const { editor } = this.control;
    if (step === "move") editor?.append("move_forward");
    if (step === "turn") editor?.append("turn");
    if (step === "run" || step === "again") this.control.run().catch(report);
  }

  /** Ends the tour, at any step; the blocks stay. */
  end(): void {
    tourFor.value = null;
  }

  dispose(): void {
    tourSteps.set(this.group, TOUR_OVER);
    clearTimeout(this.timer);
    for (const stop of this.stops) stop();
  }

  private setProgress(progress: Progress): void {
    const before = this.progress.peek();
    if (progress === before) return;
    this.progress.value = progress;
    if (progress.step === before.step) return;
    this.wait();
    this.storeStep();
  }

  private storeStep(): void {
    tourSteps.set(this.group, this.progress.peek().step);
  }

  private get group(): string {
    return this.control.open.program.group_id;
  }

  private wait(): void {
    clearTimeout(this.timer);
    this.canShow.value = false;
    this.timer = window.setTimeout(() => {
      this.canShow.value = true;
    }, SHOW_AFTER_MS);
  }

  private studioState(): StudioState {
    const { mine, open } = this.control;
    const { commands = [] } = (open.content.value?.document ?? {}) as {
      commands?: { action: string }[];
    };
    return {
      actions: commands.map(({ action }) => action),
      run: mine.value ? robot.live.value.run : null,
      isRunning: mine.value && robot.isRunning.value,
    };
  }
}
