import { useSignal } from "@preact/signals";
import { ChartLine } from "lucide-preact";
import { CapturedCard } from "../camera/CapturedCard";
import { texts } from "../i18n";
import { PanelToggle } from "../kit/PanelToggle";
import { MuteButton } from "../run/panels/MuteButton";
import { Readout } from "../run/panels/Readout";
import { RunOutput } from "../run/panels/RunOutput";
import { liveryOf } from "../scene/livery/livery";
import { Scene } from "../scene/Scene";
import { lazy } from "../shell/lazy";
import { group, robotOf } from "../shell/session";
import { ReplaySentence } from "./ReplayParts";
import type { RecordedRun } from "./recorded_run";

const PlotsPanel = lazy(async () => (await import("../plots/PlotsPanel")).PlotsPanel);

/** The floor of a recorded run, with its plots beside it or instead of it. */
export function ReplayFloor({ recordedRun }: { recordedRun: RecordedRun }) {
  const { run, playback } = recordedRun;
  const { plots, studio } = texts.value;
  const plotting = useSignal(false);
  const tall = useSignal(false);
  const besides = plotting.value ? "floor__view--beside" : "";
  return (
    <section class="floor column shrinks shrinks-down gap-2" aria-label={studio.floor}>
      <ReplaySentence run={run} view={playback.view} beginning={({ replay }) => replay.begin} />
      <div class="floor__stage column grows shrinks-down gap-2">
        <div
          class={`floor__view column grows shrinks-down gap-2 ${besides}`}
          hidden={plotting.value && tall.value}
        >
          <div class="floor__scene grows shrinks shrinks-down">
            <RecordedFloor recordedRun={recordedRun} />
            <div class="floor__corner">
              <MuteButton view={playback.view} />
            </div>
          </div>
          <RunOutput view={playback.view} />
        </div>
        <CapturedCard show={playback.show} />
        {plotting.value && (
          <div
            class={`floor__drawer floor__drawer--plots ${tall.value ? "floor__drawer--tall" : ""}`}
          >
            <PlotsPanel
              source={recordedRun.plots}
              tall={tall.value}
              onTall={(isTall) => {
                tall.value = isTall;
              }}
            />
          </div>
        )}
      </div>
      <div class="floor__foot card">
        <Readout view={playback.view} />
        <PanelToggle
          testId="plots-toggle"
          icon={ChartLine}
          text={plots.open}
          label={plots.label}
          open={plotting.value}
          onPress={() => {
            plotting.value = !plotting.value;
          }}
        />
      </div>
    </section>
  );
}

function RecordedFloor({ recordedRun: { run, playback } }: { recordedRun: RecordedRun }) {
  return (
    <Scene
      world={run.world_document}
      robot={robotOf(run.model)}
      livery={run.group_id === group.value?.id ? liveryOf(group.value) : null}
      view={playback.view}
      poseAt={playback.pose}
      whole={playback.whole}
      playing={playback.playing}
    />
  );
}
