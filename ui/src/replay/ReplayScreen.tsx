import type { RunWithVersion } from "../api/model";
import { texts } from "../i18n";
import { Loaded } from "../kit/requests/Loaded";
import { useLoaded } from "../kit/requests/useLoaded";
import { nameInHeader } from "../shell/named";
import { go, type ParametersOf } from "../shell/route";
import { couldNotOpen } from "../studio/program/open_program";
import { Replay } from "./Replay";
import { loadRecording, type Recording } from "./recording";

/** Loads the recording of a run and shows it. */
export function ReplayScreen({ run: runId }: ParametersOf<"replay">) {
  const recording = useLoaded(runId, () => load(runId), {
    onFailed: couldNotOpen,
    release: ({ playback }) => playback.dispose(),
  });
  return (
    <Loaded of={recording} as="screen" loading={texts.value.replay.loading}>
      {(loaded) => <Replay recording={loaded} onOpen={() => openProgram(loaded.run)} />}
    </Loaded>
  );
}

async function load(runId: string): Promise<Recording> {
  const recording = await loadRecording(runId);
  await nameInHeader(recording.run.program_id, recording.run.group_id);
  return recording;
}

function openProgram(run: RunWithVersion): void {
  if (run.program_id) go({ screen: "studio", program: run.program_id });
}
