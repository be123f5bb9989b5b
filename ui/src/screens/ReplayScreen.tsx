import { signal } from "@preact/signals";
import { useEffect, useState } from "preact/hooks";
import { api } from "../api/client";
import type { RunEvent, RunWithVersion } from "../api/model";
import { go } from "../app/route";
import { group, program, report } from "../app/session";
import { texts } from "../i18n";
import type { PlotSource } from "../plots/PlotsPanel";
import { History } from "../run/history";
import { Playback, type Stretch, stretches } from "../run/playback";
import { Samples } from "../run/samples";
import { decodeTelemetry, type Telemetry } from "../run/telemetry";
import { NotOpened } from "./NotOpened";
import { Replay } from "./Replay";
import "./studio.css";
import "./replay.css";

/** A recorded run with all that is needed to show any moment of it. */
export interface Recording {
  run: RunWithVersion;
  playback: Playback;
  stretches: Stretch[];
  plots: PlotSource;
}

export function ReplayScreen({ runId }: { runId: string }) {
  const [recording, setRecording] = useState<Recording | null>(null);
  const [failed, setFailed] = useState(false);
  useEffect(() => {
    let left = false;
    let made: Recording | null = null;
    load(runId).then(
      (loaded) => {
        if (left) return;
        made = loaded;
        setRecording(loaded);
      },
      (error) => {
        setFailed(true);
        report(error);
      },
    );
    return () => {
      left = true;
      made?.playback.dispose();
    };
  }, [runId]);
  if (failed) return <NotOpened />;
  if (!recording) {
    return (
      <main class="screen studio studio--opening" aria-busy="true">
        <p>{texts.value.replay.loading}</p>
      </main>
    );
  }
  return <Replay recording={recording} onOpen={() => openProgram(recording.run)} />;
}

async function load(runId: string): Promise<Recording> {
  const [run, events, samples] = await Promise.all([
    api.run(runId),
    api.runEvents(runId),
    api.runTelemetry(runId),
  ]);
  await nameInHeader(run);
  return record(run, events, samples);
}

function record(run: RunWithVersion, events: RunEvent[], samples: ArrayBuffer): Recording {
  const telemetry = decodeTelemetry(samples);
  const history = new History(run.id, events, telemetry);
  const playback = new Playback(history);
  const blocks = stretches(events, history.lastTick);
  return { run, playback, stretches: blocks, plots: plotsOf(run, playback, telemetry, blocks) };
}

/** The plots of a replay show the moment of its slider, and move it. */
function plotsOf(
  run: RunWithVersion,
  playback: Playback,
  telemetry: Telemetry,
  blocks: Stretch[],
): PlotSource {
  return {
    samples: Samples.of(telemetry),
    stretches: blocks,
    revision: signal(0),
    moment: playback.tick,
    hand: {
      onPoint: (tick) => playback.point(tick),
      onPress: (tick) => playback.seek(tick),
    },
    name: () => run.program_name ?? "",
  };
}

async function nameInHeader(run: RunWithVersion): Promise<void> {
  if (run.group_id && group.value?.id !== run.group_id) {
    group.value = (await api.groups()).find((one) => one.id === run.group_id) ?? null;
  }
  if (run.program_id && program.value?.id !== run.program_id) {
    program.value = await api.program(run.program_id);
  }
}

function openProgram(run: RunWithVersion): void {
  if (run.program_id) go({ screen: "studio", program: run.program_id });
}
