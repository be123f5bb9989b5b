import { type ReadonlySignal, useComputed } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { listen } from "../../kit/listen";
import * as robot from "../../run/live";
import { isLive } from "../../run/reducer";
import { level } from "../../shell/level";
import { connection } from "../../shell/session";
import type { StudioControl } from "../studio_control";
import { actionFor, type RunState, STOP } from "./actions";
import { DebugBar } from "./DebugBar";
import { RunBar } from "./RunBar";

/** Run, Stop, and from the second level on steps and speed. */
export function Controls({ control }: { control: StudioControl }) {
  const state = useComputed(() => stateOf(control));
  useEffect(() => followKeys(control, state), [control, state]);
  return (
    <>
      <RunBar control={control} state={state.value} />
      {level.value > 1 && <DebugBar control={control} state={state.value} />}
    </>
  );
}

function stateOf(control: StudioControl): RunState {
  const { phase, run, output } = robot.live.value;
  const isOther = isLive(robot.live.value) && !control.mine.value;
  return {
    phase: isOther && run ? "idle" : phase,
    // the server waits for an engine that starts, and starts a lost one
    unable: (isOther && phase !== "starting") || connection.value !== "open",
    inFunction: output.calls.length > 0,
    stepwise: level.value > 1,
  };
}

function followKeys(control: StudioControl, state: ReadonlySignal<RunState>): () => void {
  const onKey = (event: KeyboardEvent) => {
    const action = event.repeat ? undefined : actionFor(event, state.peek());
    // the world editor covers the buttons and has its own Stop
    if (!action || (control.worlds.store.peek() && action !== STOP)) return;
    event.preventDefault();
    action.perform(control, state.peek());
  };
  return listen(window, { keydown: onKey });
}
