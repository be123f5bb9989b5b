import type { RunWithVersion } from "../api/model";
import { texts } from "../i18n";
import { Loaded } from "../kit/requests/Loaded";
import { useLoaded } from "../kit/requests/useLoaded";
import { nameInHeader } from "../shell/named";
import { go, type ParametersOf } from "../shell/route";
import { couldNotOpen } from "../studio/program/open_program";
import { Replay } from "./Replay";
import { loadRecordedRun, needsRepair, type RecordedRun } from "./recorded_run";

/** Loads the recording of a run and shows it. */
export function ReplayScreen({ run: runId }: ParametersOf<"replay">) {
  const recordedRun = useLoaded(runId, () => load(runId), {
    onFailed: couldNotOpen,
    release: ({ playback }) => playback.dispose(),
  });
  return (
    <Loaded of={recordedRun} as="screen" loading={texts.value.replay.loading}>
      {(loaded) => <Replay recordedRun={loaded} onOpen={() => openProgram(loaded.run)} />}
    </Loaded>
  );
}

async function load(runId: string): Promise<RecordedRun> {
  const recordedRun = await loadRecordedRun(runId);
  const { playback } = recordedRun;
  if (needsRepair(recordedRun)) playback.seek(playback.end);
  await nameInHeader(recordedRun.run.program_id, recordedRun.run.group_id);
  return recordedRun;
}

function openProgram(run: RunWithVersion): void {
  if (run.program_id) go({ screen: "studio", program: run.program_id });
}
