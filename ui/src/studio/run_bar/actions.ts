import {
  CornerDownRight,
  CornerUpLeft,
  type LucideIcon,
  Pause,
  Play,
  Redo2,
  Square,
  StepForward,
} from "lucide-preact";
import type { Texts } from "../../i18n";
import type { Phase } from "../../run/reducer";
import type { StudioControl } from "../studio_control";

/** State that enables and disables actions. */
export interface RunState {
  readonly phase: Phase;
  /** Whether Run is disabled; the status line shows the reason. */
  readonly unable: boolean;
  /** Whether the run is paused inside a function, so that "step out" is possible. */
  readonly inFunction: boolean;
  /** Whether the step buttons are shown. */
  readonly stepwise: boolean;
}

/** An action on a run, used by buttons and keyboard. */
export interface RunAction {
  readonly name: string;
  /** The key, in the form of `keyOf`. */
  readonly shortcut: string;
  readonly testId: string;
  icon(state: RunState): LucideIcon;
  label(texts: Texts, state: RunState): string;
  help?(texts: Texts): string;
  isShown(state: RunState): boolean;
  isReady(state: RunState): boolean;
  perform(control: StudioControl, state: RunState): void;
}

const RUN_KEY = "F8";
const always = () => true;
const isPaused = ({ phase }: RunState) => phase === "paused";
const isRunning = ({ phase }: RunState) => phase === "running";
const isIdle = ({ phase }: RunState) =>
  phase !== "running" && phase !== "paused" && phase !== "starting";

export const STOP: RunAction = {
  name: "stop",
  shortcut: "Shift+F8",
  testId: "stop",
  icon: () => Square,
  label: ({ run }) => run.stop,
  isShown: always,
  isReady: always,
  perform: (control) => control.stop(),
};

/** Actions of one button; one is shown at a time. */
export const RUN_PAUSE_RESUME: readonly RunAction[] = [
  {
    name: "pause",
    shortcut: RUN_KEY,
    testId: "run",
    icon: () => Pause,
    label: ({ run }) => run.pause,
    isShown: isRunning,
    isReady: always,
    perform: (control) => control.send({ do: "pause" }),
  },
  {
    name: "resume",
    shortcut: RUN_KEY,
    testId: "run",
    icon: () => Play,
    label: ({ run }) => run.resume,
    isShown: isPaused,
    isReady: always,
    perform: (control) => control.send({ do: "resume" }),
  },
  {
    name: "run",
    shortcut: RUN_KEY,
    testId: "run",
    icon: () => Play,
    label: ({ run }, { phase }) => (phase === "starting" ? run.starting : run.run),
    isShown: (state) => !isRunning(state) && !isPaused(state),
    isReady: ({ phase, unable }) => !unable && phase !== "starting",
    perform: (control) => void control.run(),
  },
];

export const STEPS: readonly RunAction[] = [
  {
    name: "step",
    shortcut: "F7",
    testId: "step",
    icon: () => StepForward,
    label: ({ debug }) => debug.step,
    help: ({ debug }) => debug.stepHelp,
    isShown: ({ stepwise }) => stepwise,
    isReady: (state) => (isIdle(state) ? !state.unable : isPaused(state)),
    perform: (control, state) =>
      isIdle(state) ? void control.run(true) : control.send({ do: "step", mode: "into" }),
  },
  {
    name: "over",
    shortcut: "F10",
    testId: "step-over",
    icon: ({ inFunction }) => (inFunction ? Redo2 : CornerDownRight),
    label: ({ debug }) => debug.over,
    help: ({ debug }) => debug.overHelp,
    isShown: (state) => state.stepwise && isPaused(state),
    isReady: always,
    perform: (control) => control.send({ do: "step", mode: "over" }),
  },
  {
    name: "out",
    shortcut: "Shift+F7",
    testId: "step-out",
    icon: () => CornerUpLeft,
    label: ({ debug }) => debug.out,
    help: ({ debug }) => debug.outHelp,
    isShown: (state) => state.stepwise && isPaused(state) && state.inFunction,
    isReady: always,
    perform: (control) => control.send({ do: "step", mode: "out" }),
  },
];

export const ACTIONS: readonly RunAction[] = [STOP, ...RUN_PAUSE_RESUME, ...STEPS];

type Key = Pick<KeyboardEvent, "key" | "shiftKey" | "ctrlKey" | "altKey" | "metaKey">;

/** The key as a shortcut name; "" with modifiers of the browser or the system. */
export const keyOf = ({ key, shiftKey, ctrlKey, altKey, metaKey }: Key): string =>
  ctrlKey || altKey || metaKey ? "" : `${shiftKey ? "Shift+" : ""}${key}`;

/** The enabled action of a key. */
export const actionFor = (key: Key, state: RunState): RunAction | undefined =>
  ACTIONS.find(
    (action) => action.shortcut === keyOf(key) && action.isShown(state) && action.isReady(state),
  );
