import { useComputed, useSignal } from "@preact/signals";
import { Braces } from "lucide-preact";
import { connection, engine, worlds } from "../app/session";
import { TEST } from "../app/testids";
import { texts } from "../i18n";
import { CapturePanel } from "../run/CapturePanel";
import { IrPanel } from "../run/IrPanel";
import * as robot from "../run/live";
import { Readout } from "../run/Readout";
import { RunBar } from "../run/RunBar";
import { isLive } from "../run/reducer";
import { StatusLine } from "../run/StatusLine";
import { WorldChoice } from "../run/WorldChoice";
import { Scene } from "../scene/Scene";
import type { StudioControl } from "./studio_control";
import "../run/run.css";

export function FloorPane({ control }: { control: StudioControl }) {
  const irOpen = useSignal(false);
  const asking = useComputed(() => robot.live.value.capture !== null);
  return (
    <section class="floor" aria-label={texts.value.studio.floor}>
      <Controls control={control} />
      <Status control={control} />
      <div class="floor__stage">
        <div class="floor__scene">
          <Scene world={control.world.value} view={robot.live} poseAt={robot.livePose} />
          <World control={control} />
        </div>
        {asking.value ? (
          <CaptureWhileAsked control={control} />
        ) : (
          irOpen.value && (
            <div class="floor__drawer">
              <IrPanel document={control.open.content.value?.document ?? null} />
            </div>
          )
        )}
      </div>
      <div class="floor__foot card">
        <Readout view={robot.live} />
        <button
          type="button"
          class="button button--plain floor__ir"
          data-testid={TEST.irToggle}
          aria-expanded={irOpen.value}
          onClick={() => {
            irOpen.value = !irOpen.value;
          }}
        >
          <Braces class="icon" aria-hidden="true" />
          <span>{texts.value.ir.tab}</span>
        </button>
      </div>
    </section>
  );
}

function Controls({ control }: { control: StudioControl }) {
  const phase = useComputed(() => robot.live.value.phase);
  const elsewhere = useComputed(() => isLive(robot.live.value) && !control.mine.value);
  const ready = engine.value === "ready" && connection.value === "open";
  return (
    <RunBar
      phase={elsewhere.value && robot.live.value.run ? "idle" : phase.value}
      unable={(elsewhere.value && phase.value !== "starting") || !ready}
      onRun={() => void control.run()}
      onPause={() => control.send(robot.pause)}
      onResume={() => control.send(robot.resume)}
      onStop={() => control.send(robot.stop)}
    />
  );
}

function Status({ control }: { control: StudioControl }) {
  return <StatusLine sentence={control.sentence.value} />;
}

function World({ control }: { control: StudioControl }) {
  const busy = useComputed(() => isLive(robot.live.value));
  return (
    <WorldChoice
      worlds={worlds.value}
      world={control.worldName.value}
      busy={busy.value}
      onWorld={(name) => control.chooseWorld(name)}
    />
  );
}

function CaptureWhileAsked({ control }: { control: StudioControl }) {
  const { capture, tick } = robot.live.value;
  if (!capture) return null;
  return (
    <CapturePanel
      capture={capture}
      tick={tick}
      onAnswer={(result) => control.send(() => robot.answerCapture(result))}
    />
  );
}
