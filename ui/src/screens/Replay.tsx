import { useSignal } from "@preact/signals";
import { Blocks, ChartLine, Eye } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { door, giveUpWaiting, pinAsked } from "../app/teacher";
import { TEST } from "../app/testids";
import { texts } from "../i18n";
import { RunNotes } from "../notes/RunNotes";
import { MuteButton } from "../run/MuteButton";
import type { Playback } from "../run/playback";
import { Readout } from "../run/Readout";
import { Shown } from "../run/Shown";
import { beep } from "../run/sound";
import { Scene } from "../scene/Scene";
import { FootButton } from "./FootButton";
import { later } from "./later";
import { ReplayBlocks, ReplayWords } from "./ReplayParts";
import type { Recording } from "./recording";
import { Transport } from "./Transport";

const TeacherNote = later(async () => (await import("../review/TeacherNote")).TeacherNote);
const DoorForm = later(async () => (await import("../teacher/DoorForm")).DoorForm);
const PlotsPanel = later(async () => (await import("../plots/PlotsPanel")).PlotsPanel);

interface ReplayProps {
  recording: Recording;
  onOpen(): void;
}

/** A run that was; where a note waits for the PIN, the PIN is asked for first, and what is behind is kept. */
export function Replay(properties: ReplayProps) {
  useEffect(() => giveUpWaiting, []);
  return (
    <div class="replay-place" data-waits={pinAsked.value || undefined}>
      {pinAsked.value && <DoorForm again />}
      <Replayed {...properties} />
    </div>
  );
}

/** Floor, blocks and time of a run that was. */
function Replayed({ recording, onOpen }: ReplayProps) {
  const { run, playback } = recording;
  const { replay, plots } = texts.value;
  const plotting = useSignal(false);
  const tall = useSignal(false);
  const forTeacher = door.value?.is_open || pinAsked.value;
  const besides = plotting.value ? "floor__view--beside" : "";
  useEffect(() => soundOf(playback), [playback]);
  return (
    <main class="screen replay">
      <h1 class="visually-hidden">{replay.title}</h1>
      <section class="blocks" aria-label={replay.ofVersion}>
        <div class="blocks__tools replay__tools">
          <Eye class="icon" aria-hidden="true" />
          <p>{run.version ? replay.readOnly : replay.noVersion}</p>
          {run.program_id && (
            <button type="button" class="button" data-testid={TEST.replayProgram} onClick={onOpen}>
              <Blocks class="icon" aria-hidden="true" />
              {replay.openProgram}
            </button>
          )}
        </div>
        {!forTeacher && <RunNotes runId={run.id} />}
        <ReplayBlocks run={run} view={playback.view} />
        {forTeacher && run.group_id && <TeacherNote key={run.id} run={run.id} />}
      </section>
      <section class="floor" aria-label={texts.value.studio.floor}>
        <ReplayWords run={run} view={playback.view} />
        <div class="floor__stage">
          <div class={`floor__view ${besides}`} hidden={plotting.value && tall.value}>
            <div class="floor__scene">
              <Scene world={run.world_document} view={playback.view} poseAt={playback.pose} />
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
            testId={TEST.plotsToggle}
            Icon={ChartLine}
            word={plots.open}
            label={plots.label}
            open={plotting.value}
            onClick={() => {
              plotting.value = !plotting.value;
            }}
          />
        </div>
      </section>
      <Transport playback={playback} tracks={[recording.stretches]} />
    </main>
  );
}

/** Faster than this a beep is noise. */
const LOUD_SPEED = 2;

function soundOf(playback: Playback): () => void {
  let heard = playback.view.value.output.beeps;
  return playback.view.subscribe(({ output: { beeps } }) => {
    const { playing, speed } = playback;
    if (beeps > heard && playing.peek() && speed.peek() <= LOUD_SPEED) beep();
    heard = beeps;
  });
}
