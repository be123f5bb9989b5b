import { type Signal, useSignal } from "@preact/signals";
import { ChartLine, Ghost } from "lucide-preact";
import { CapturedCard } from "../camera/CapturedCard";
import { texts } from "../i18n";
import { PanelToggle } from "../kit/PanelToggle";
import { PredictionLine } from "../prediction/PredictionLine";
import { PredictionPanel } from "../prediction/PredictionPanel";
import { PredictionSwitch } from "../prediction/PredictionSwitch";
import { MuteButton } from "../run/panels/MuteButton";
import { Readout } from "../run/panels/Readout";
import { RunOutput } from "../run/panels/RunOutput";
import { liveryOf } from "../scene/livery/livery";
import { Scene } from "../scene/Scene";
import { lazy } from "../shell/lazy";
import { group, robotOf } from "../shell/session";
import { isOfRealRobot, type Predicted } from "./predicted";
import { ReplaySentence } from "./ReplayParts";
import type { RecordedRun } from "./recorded_run";

const PlotsPanel = lazy(async () => (await import("../plots/PlotsPanel")).PlotsPanel);

interface ReplayFloorProps {
  recordedRun: RecordedRun;
  predicted: Predicted;
}

interface FloorPartProps extends ReplayFloorProps {
  drawer: Signal<"plots" | "prediction" | null>;
  tall: Signal<boolean>;
}

/** The floor of a recorded run, with its plots or its prediction beside it or instead of it. */
export function ReplayFloor({ recordedRun, predicted }: ReplayFloorProps) {
  const { run, playback } = recordedRun;
  const drawer = useSignal<"plots" | "prediction" | null>(null);
  const tall = useSignal(false);
  const parts = { recordedRun, predicted, drawer, tall };
  const besides = drawer.value ? "floor__view--beside" : "";
  return (
    <section class="floor column shrinks shrinks-down gap-2" aria-label={texts.value.studio.floor}>
      <ReplaySentence run={run} view={playback.view} beginning={({ replay }) => replay.begin} />
      {drawer.value !== "prediction" && <Differing predicted={predicted} />}
      <div class="floor__stage column grows shrinks-down gap-2">
        <div
          class={`floor__view column grows shrinks-down gap-2 ${besides}`}
          hidden={drawer.value === "plots" && tall.value}
        >
          <div class="floor__scene grows shrinks shrinks-down">
            <RecordedFloor recordedRun={recordedRun} predicted={predicted} />
            <div class="floor__corner">
              {predicted.prediction.value && (
                <PredictionSwitch robot={predicted.prediction.value.robot} />
              )}
              <MuteButton view={playback.view} />
            </div>
          </div>
          <RunOutput view={playback.view} />
        </div>
        <CapturedCard show={playback.show} />
        <Drawer {...parts} />
      </div>
      <Foot {...parts} />
    </section>
  );
}

/** What a real robot did otherwise than predicted, or why nothing is predicted. */
function Differing({ predicted: { prediction, problem } }: Pick<ReplayFloorProps, "predicted">) {
  if (prediction.value) return <PredictionLine prediction={prediction.value} />;
  if (!problem.value) return null;
  return (
    <p class="prediction-line" data-testid="prediction-problem">
      {problem.value}
    </p>
  );
}

function Drawer({ recordedRun, predicted, drawer, tall }: FloorPartProps) {
  const { value: prediction } = predicted.prediction;
  if (drawer.value === "plots") {
    return (
      <div class={`floor__drawer floor__drawer--plots ${tall.value ? "floor__drawer--tall" : ""}`}>
        <PlotsPanel
          source={recordedRun.plots}
          tall={tall.value}
          onTall={(isTall) => {
            tall.value = isTall;
          }}
        />
      </div>
    );
  }
  if (drawer.value !== "prediction" || !prediction) return null;
  return (
    <div class="floor__drawer">
      <PredictionPanel
        prediction={prediction}
        onTick={(tick) => {
          recordedRun.playback.pause();
          recordedRun.playback.seek(tick);
        }}
      />
    </div>
  );
}

function Foot({ recordedRun, predicted, drawer }: FloorPartProps) {
  const { plots, prediction } = texts.value;
  const toggle = (part: "plots" | "prediction") => {
    drawer.value = drawer.value === part ? null : part;
  };
  return (
    <div class="floor__foot card">
      <Readout view={recordedRun.playback.view} />
      {isOfRealRobot(recordedRun.run) && (
        <PanelToggle
          testId="prediction-toggle"
          icon={Ghost}
          text={prediction.open}
          label={prediction.label}
          open={drawer.value === "prediction"}
          disabled={!predicted.prediction.value}
          onPress={() => toggle("prediction")}
        />
      )}
      <PanelToggle
        testId="plots-toggle"
        icon={ChartLine}
        text={plots.open}
        label={plots.label}
        open={drawer.value === "plots"}
        onPress={() => toggle("plots")}
      />
    </div>
  );
}

function RecordedFloor({ recordedRun: { run, playback }, predicted }: ReplayFloorProps) {
  return (
    <Scene
      world={run.world_document}
      robot={robotOf(run.model)}
      livery={run.group_id === group.value?.id ? liveryOf(group.value) : null}
      view={playback.view}
      poseAt={playback.pose}
      whole={playback.whole}
      companion={predicted.companion}
      playing={playback.playing}
    />
  );
}
