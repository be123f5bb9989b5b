import { Pause, Play, Square } from "lucide-preact";
import { TEST } from "../app/testids";
import { texts } from "../i18n";
import type { Phase } from "./reducer";

interface RunBarProps {
  phase: Phase;
  /** Run is out of reach, for a reason that the status line tells. */
  unable: boolean;
  onRun(): void;
  onPause(): void;
  onResume(): void;
  onStop(): void;
}

/** Run, which becomes Pause; and Stop, always there and always red. */
export function RunBar(props: RunBarProps) {
  const { run } = texts.value;
  return (
    <section class="run-bar" aria-label={run.bar}>
      <RunButton {...props} />
      <button
        type="button"
        class="button button--stop run-bar__stop"
        data-testid={TEST.stop}
        onClick={props.onStop}
      >
        <Square class="icon" fill="currentColor" aria-hidden="true" />
        {run.stop}
      </button>
    </section>
  );
}

function RunButton({ phase, unable, onRun, onPause, onResume }: RunBarProps) {
  const { run } = texts.value;
  const look = "button button--run run-bar__run";
  if (phase === "running") {
    return (
      <button type="button" class={look} data-testid={TEST.run} data-does="pause" onClick={onPause}>
        <Pause class="icon" fill="currentColor" aria-hidden="true" />
        {run.pause}
      </button>
    );
  }
  if (phase === "paused") {
    return (
      <button
        type="button"
        class={look}
        data-testid={TEST.run}
        data-does="resume"
        onClick={onResume}
      >
        <Play class="icon" fill="currentColor" aria-hidden="true" />
        {run.resume}
      </button>
    );
  }
  return (
    <button
      type="button"
      class={look}
      data-testid={TEST.run}
      data-does="run"
      disabled={unable || phase === "starting"}
      onClick={onRun}
    >
      <Play class="icon" fill="currentColor" aria-hidden="true" />
      {phase === "starting" ? run.starting : run.run}
    </button>
  );
}
