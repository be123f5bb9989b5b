import { useComputed } from "@preact/signals";
import { level } from "../app/level";
import { connection, engine } from "../app/session";
import { DebugBar } from "../debug/DebugBar";
import * as robot from "../run/live";
import { RunBar } from "../run/RunBar";
import { isLive } from "../run/reducer";
import type { StudioControl } from "./studio_control";

/** Run, Stop, and from the second level on steps and speed. */
export function Controls({ control }: { control: StudioControl }) {
  const live = useComputed(() => robot.live.value.phase);
  const elsewhere = useComputed(() => isLive(robot.live.value) && !control.mine.value);
  const inFunction = useComputed(() => robot.live.value.output.calls.length > 0);
  const ready = engine.value === "ready" && connection.value === "open";
  const phase = elsewhere.value && robot.live.value.run ? "idle" : live.value;
  const unable = (elsewhere.value && live.value !== "starting") || !ready;
  return (
    <>
      <RunBar
        phase={phase}
        unable={unable}
        onRun={() => void control.run()}
        onPause={() => control.send(robot.pause)}
        onResume={() => control.send(robot.resume)}
        onStop={() => control.send(robot.stop)}
      />
      {level.value > 1 && (
        <DebugBar
          phase={phase}
          inFunction={inFunction.value}
          unable={unable}
          onBegin={() => void control.run(true)}
          onStep={(mode) => control.send(() => robot.step(mode))}
        />
      )}
    </>
  );
}
