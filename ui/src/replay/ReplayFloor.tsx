import { useSignal } from "@preact/signals";
import { ChartLine } from "lucide-preact";
import { texts } from "../i18n";
import { FootButton } from "../kit/FootButton";
import { MuteButton } from "../run/panels/MuteButton";
import { Readout } from "../run/panels/Readout";
import { Shown } from "../run/panels/Shown";
import { Scene } from "../scene/Scene";
import { later } from "../shell/later";
import { robotOf } from "../shell/session";
import { ReplayWords } from "./ReplayParts";
import type { Recording } from "./recording";

const PlotsPanel = later(async () => (await import("../plots/PlotsPanel")).PlotsPanel);

/** The floor of a recorded run, with its plots beside it or in its place. */
export function ReplayFloor({ recording }: { recording: Recording }) {
  const { run, playback } = recording;
  const { plots, studio } = texts.value;
  const plotting = useSignal(false);
  const tall = useSignal(false);
  const besides = plotting.value ? "floor__view--beside" : "";
  return (
    <section class="floor column shrinks shrinks-down gap-2" aria-label={studio.floor}>
      <ReplayWords run={run} view={playback.view} />
      <div class="floor__stage column grows shrinks-down gap-2">
        <div
          class={`floor__view column grows shrinks-down gap-2 ${besides}`}
          hidden={plotting.value && tall.value}
        >
          <div class="floor__scene grows shrinks shrinks-down">
            <Scene
              world={run.world_document}
              robot={robotOf(run.model)}
              view={playback.view}
              poseAt={playback.pose}
              playing={playback.playing}
            />
            <div class="floor__corner">
              <MuteButton view={playback.view} />
            </div>
          </div>
          <Shown view={playback.view} />
        </div>
        {plotting.value && (
          <div
            class={`floor__drawer floor__drawer--plots ${tall.value ? "floor__drawer--tall" : ""}`}
          >
            <PlotsPanel
              source={recording.plots}
              tall={tall.value}
              onTall={(wanted) => {
                tall.value = wanted;
              }}
            />
          </div>
        )}
      </div>
      <div class="floor__foot card">
        <Readout view={playback.view} />
        <FootButton
          testId="plots-toggle"
          icon={ChartLine}
          word={plots.open}
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
