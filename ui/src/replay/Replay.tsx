import { Blocks, Eye } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import type { Playback } from "../run/playback";
import { RobotName } from "../run/real/RobotName";
import { VerdictLine } from "../run/real/VerdictLine";
import { beep } from "../run/sounds/sound";
import { SaveRunImage } from "../run_image/SaveRunImage";
import { lazy } from "../shell/lazy";
import { PresentButton } from "../shell/projector/PresentButton";
import { cancelWaiting, isPinAsked, teacherSession } from "../shell/teacher/teacher_session";
import { MeasuredRun } from "../truth/TruthLines";
import { PlaybackControls } from "./PlaybackControls";
import { type Predicted, usePredicted } from "./predicted";
import { ReplayFloor } from "./ReplayFloor";
import { ReplayBlocks } from "./ReplayParts";
import { RunNotes } from "./RunNotes";
import type { RecordedRun } from "./recorded_run";

const TeacherNote = lazy(
  async () => (await import("../teacher/review/notes/TeacherNote")).TeacherNote,
);
const SignInForm = lazy(async () => (await import("../teacher/sign_in/SignInForm")).SignInForm);

interface ReplayProps {
  recordedRun: RecordedRun;
  onOpen(): void;
}

/**
 * A recorded run. If saving a note requires the PIN, the sign-in form covers the replay, whose
 * state is preserved.
 */
export function Replay(properties: ReplayProps) {
  useEffect(() => cancelWaiting, []);
  return (
    <div class="replay-place column grows shrinks-down" data-waits={isPinAsked.value || undefined}>
      {isPinAsked.value && <SignInForm again />}
      <Replayed {...properties} />
    </div>
  );
}

/** Floor, blocks and playback controls of a recorded run. */
function Replayed({ recordedRun, onOpen }: ReplayProps) {
  const { playback, stretches, captures } = recordedRun;
  const predicted = usePredicted(recordedRun);
  useEffect(() => soundOf(playback), [playback]);
  return (
    <main class="screen replay">
      <h1 class="visually-hidden">{texts.value.replay.title}</h1>
      <ReplayProgram recordedRun={recordedRun} predicted={predicted} onOpen={onOpen} />
      <ReplayFloor recordedRun={recordedRun} predicted={predicted} />
      <PlaybackControls playback={playback} tracks={[stretches]} answers={captures} />
    </main>
  );
}

/** The blocks of the run and the teacher's notes about it. */
function ReplayProgram({ recordedRun, predicted, onOpen }: ReplayProps & { predicted: Predicted }) {
  const { run, playback } = recordedRun;
  const { replay } = texts.value;
  const what = run.version ? replay.readOnly : replay.noVersion;
  const forTeacher = teacherSession.value?.is_open || isPinAsked.value;
  return (
    <section class="blocks" aria-label={replay.ofVersion}>
      <div class="blocks__tools replay__tools row middle rigid gap-1">
        <span class="icon" title={what}>
          <Eye class="icon" aria-hidden="true" />
        </span>
        <p title={what} data-shortened>
          {what}
        </p>
        <RobotName link={run.link} calibrated={run.calibrated_robot} />
        {forTeacher && <PresentButton first={run.id} />}
        <SaveRunImage runId={run.id} opens="below" />
        {run.program_id && (
          <Button icon={Blocks} testId="replay-program" onPress={onOpen}>
            {replay.openProgram}
          </Button>
        )}
      </div>
      <VerdictLine of={run} />
      <MeasuredRun run={run} />
      {!forTeacher && <RunNotes runId={run.id} />}
      <ReplayBlocks run={run} view={playback.view} predicted={predicted} />
      {forTeacher && run.group_id && (
        <TeacherNote key={run.id} run={run.id} otherComputer={run.other_computer} />
      )}
    </section>
  );
}

/** Above this speed beeps are not played. */
const LOUD_SPEED = 2;

function soundOf(playback: Playback): () => void {
  let playedCount = playback.view.value.output.beeps.count;
  return playback.view.subscribe(({ output: { beeps } }) => {
    const { playing, speed } = playback;
    if (beeps.count > playedCount && playing.peek() && speed.peek() <= LOUD_SPEED) beep();
    playedCount = beeps.count;
  });
}
