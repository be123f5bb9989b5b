import { signal } from "@preact/signals";
import { api } from "../api/client";
import type { RunEvent, RunWithVersion } from "../api/model";
import type { PlotSource } from "../plots/plot_source";
import { Playback, type Stretch, timelineOf } from "../run/playback";
import { RecordedStates } from "../run/recorded_states";
import type { CaptureAnswer } from "../run/reducer";
import { Samples } from "../run/samples";
import { decodeTelemetry, type Telemetry } from "../run/telemetry";
import { outcomeOf } from "../teacher/review/model";

/** A recorded run with the data needed to show any tick of it. */
export interface RecordedRun {
  run: RunWithVersion;
  playback: Playback;
  stretches: Stretch[];
  captures: readonly CaptureAnswer[];
  plots: PlotSource;
}

/** Loads all data of a run. */
export async function loadRecordedRun(runId: string): Promise<RecordedRun> {
  const [run, events, samples] = await Promise.all([
    api.run(runId),
    api.runEvents(runId),
    api.runTelemetry(runId),
  ]);
  return assemble(run, events, samples);
}

/** Whether the run ended with something to mend: it is then opened at its end, which says what. */
export function needsRepair({ run }: RecordedRun): boolean {
  return ["failed", "notyet"].includes(outcomeOf(run));
}

function assemble(run: RunWithVersion, events: RunEvent[], samples: ArrayBuffer): RecordedRun {
  const telemetry = decodeTelemetry(samples);
  const history = new RecordedStates(run.id, events, telemetry);
  const timeline = timelineOf(events);
  const { captures } = timeline;
  const playback = new Playback(history, captures);
  const stretches = timeline.until(history.lastTick);
  const plots = plotsOf(run, playback, telemetry, stretches);
  return { run, playback, stretches, captures, plots };
}

/** The plots of a replay. They share the tick of the time slider: they show it and set it. */
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
    selectedTick: playback.tick,
    input: {
      onPoint: (tick) => playback.point(tick),
      onPress: (tick) => playback.seek(tick),
    },
    name: () => run.program_name ?? "",
  };
}
