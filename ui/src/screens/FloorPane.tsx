import { useComputed, useSignal } from "@preact/signals";
import { FileCode } from "lucide-preact";
import { worlds } from "../app/session";
import { TEST } from "../app/testids";
import { texts } from "../i18n";
import { CapturePanel } from "../run/CapturePanel";
import * as robot from "../run/live";
import { MuteButton } from "../run/MuteButton";
import { QuestionPanel } from "../run/QuestionPanel";
import { Readout } from "../run/Readout";
import { isLive } from "../run/reducer";
import { Shown } from "../run/Shown";
import { StatusLine } from "../run/StatusLine";
import { DRAWER, TextDrawer } from "../run/text/TextDrawer";
import { WorldChoice } from "../run/WorldChoice";
import { Scene } from "../scene/Scene";
import { Controls } from "./Controls";
import type { StudioControl } from "./studio_control";
import "../run/run.css";

export function FloorPane({ control }: { control: StudioControl }) {
  const textOpen = useSignal(false);
  const drawer = useSignal(DRAWER);
  const tall = textOpen.value && drawer.value.tall;
  return (
    <section class="floor" aria-label={texts.value.studio.floor}>
      <Controls control={control} />
      <Status control={control} />
      <div class="floor__stage">
        <div class="floor__scene" hidden={tall}>
          <Scene world={control.world.value} view={robot.live} poseAt={robot.livePose} />
          <Corner control={control} />
        </div>
        {!tall && <Shown view={robot.live} />}
        <Asked control={control} />
        {textOpen.value && (
          <div class={`floor__drawer ${tall ? "floor__drawer--tall" : ""}`}>
            <TextDrawer
              state={drawer.value}
              document={control.open.content.value?.document ?? null}
              running={control.running.value}
              onState={(state) => {
                drawer.value = state;
              }}
              onPlace={(document) => control.place(document)}
            />
          </div>
        )}
      </div>
      <div class="floor__foot card">
        <Readout view={robot.live} />
        <button
          type="button"
          class="button button--plain floor__ir"
          data-testid={TEST.irToggle}
          aria-expanded={textOpen.value}
          // what is being written is not thrown away
          disabled={textOpen.value && drawer.value.editing}
          onClick={() => {
            textOpen.value = !textOpen.value;
          }}
        >
          <FileCode class="icon" aria-hidden="true" />
          <span>{texts.value.python.open}</span>
        </button>
      </div>
    </section>
  );
}

function Status({ control }: { control: StudioControl }) {
  return <StatusLine sentence={control.sentence.value} />;
}

function Corner({ control }: { control: StudioControl }) {
  const busy = useComputed(() => isLive(robot.live.value));
  return (
    <div class="floor__corner">
      <WorldChoice
        worlds={worlds.value}
        world={control.worldName.value}
        busy={busy.value}
        onWorld={(name) => control.chooseWorld(name)}
      />
      <MuteButton view={robot.live} expected={control.beeps.value} />
    </div>
  );
}

/** What the program waits for a person to say; the group that made the program answers. */
function Asked({ control }: { control: StudioControl }) {
  const capturing = useComputed(() => robot.live.value.capture !== null);
  const question = useComputed(() => robot.live.value.output.question);
  if (capturing.value) return <CaptureWhileAsked control={control} />;
  if (!question.value || !control.mine.value) return null;
  return (
    <QuestionPanel
      question={question.value}
      onAnswer={(value) => control.send(() => robot.answerQuestion(value))}
    />
  );
}

function CaptureWhileAsked({ control }: { control: StudioControl }) {
  const { capture, tick } = robot.live.value;
  if (!capture) return null;
  return (
    <CapturePanel
      capture={capture}
      tick={tick}
      onAnswer={(result) => control.send(() => robot.answerCapture(result))}
    />
  );
}
