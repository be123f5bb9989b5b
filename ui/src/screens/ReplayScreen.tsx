import { useEffect, useState } from "preact/hooks";
import { api } from "../api/client";
import type { RunWithVersion } from "../api/model";
import { couldNotOpen } from "../app/open_program";
import { go } from "../app/route";
import { group, program } from "../app/session";
import { texts } from "../i18n";
import { NotOpened } from "./NotOpened";
import { Replay } from "./Replay";
import { loadRecording, type Recording } from "./recording";

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
        if (left) return;
        setFailed(true);
        couldNotOpen(error);
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
  const recording = await loadRecording(runId);
  await nameInHeader(recording.run);
  return recording;
}

async function nameInHeader(run: RunWithVersion): Promise<void> {
  if (group.value?.id !== run.group_id) {
    const groups = run.group_id ? await api.groups() : [];
    group.value = groups.find((one) => one.id === run.group_id) ?? null;
  }
  if (program.value?.id !== run.program_id) {
    program.value = run.program_id ? await api.program(run.program_id) : null;
  }
}

function openProgram(run: RunWithVersion): void {
  if (run.program_id) go({ screen: "studio", program: run.program_id });
}
