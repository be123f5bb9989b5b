import { type Signal, useComputed } from "@preact/signals";
import { Lock, Pencil } from "lucide-preact";
import { worldTitle } from "../../api/model";
import { language, texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { liveSource } from "../../plots/live_source";
import { liveGhost, livePrediction } from "../../prediction/live_prediction";
import { PredictionSwitch } from "../../prediction/PredictionSwitch";
import { isNow, shown, shownPose } from "../../run/inspected_tick";
import * as robot from "../../run/live";
import type { Question } from "../../run/output";
import { MuteButton } from "../../run/panels/MuteButton";
import { RunOutput } from "../../run/panels/RunOutput";
import { activeRealLink, chosenRobot } from "../../run/real/real_robot";
import { robotStates } from "../../run/real/robot_state";
import { stateText } from "../../run/real/state_text";
import { isLive } from "../../run/reducer";
import { liveryOf } from "../../scene/livery/livery";
import { Scene } from "../../scene/Scene";
import { lazy } from "../../shell/lazy";
import { group, worlds } from "../../shell/session";
import { sensorValues } from "../debug/sensor_values";
import { RobotChoice } from "../real_robot/RobotChoice";
import type { StudioControl } from "../studio_control";
import type { DrawerState } from "../text/drawer";
import { CapturePanel } from "./CapturePanel";
import { QuestionPanel } from "./QuestionPanel";
import { useSolved } from "./solved";
import { WorldChoice } from "./WorldChoice";

const CapturedCard = lazy(async () => (await import("../../camera/CapturedCard")).CapturedCard);
const TextDrawer = lazy(async () => (await import("../text/TextDrawer")).TextDrawer);
const PlotsPanel = lazy(async () => (await import("../../plots/PlotsPanel")).PlotsPanel);

interface StageProps {
  control: StudioControl;
  drawer: Signal<DrawerState>;
}

/**
 * The floor with the program's output, and below it one panel: a question of the program, else
 * program text or plots. Two parts fit: a question has priority over text and plots, and edited
 * text has priority over the floor.
 */
export function Stage({ control, drawer }: StageProps) {
  const capturing = useComputed(() => robot.live.value.capture !== null);
  const asked = useComputed(() => (control.mine.value ? robot.live.value.output.question : null));
  const waits = capturing.value || asked.value !== null;
  const { open, what, tall, editing } = drawer.value;
  const hasText = open && (editing || !waits);
  return (
    <div class="floor__stage column grows shrinks-down gap-2">
      <div
        class={`floor__view column grows shrinks-down gap-2 ${hasText ? "floor__view--beside" : ""}`}
        hidden={hasText && (tall || editing)}
      >
        <div class="floor__scene grows shrinks shrinks-down">
          <StudioFloor control={control} />
          <Corner control={control} />
        </div>
        {!waits && <RunOutput view={shown} more={sensorValues} />}
      </div>
      {control.captures.value && <CapturedCard show={robot.captureShow} />}
      {capturing.value && <CaptureWhileAsked control={control} />}
      {asked.value && <Asked control={control} question={asked.value} />}
      {hasText && (
        <div
          class={`floor__drawer floor__drawer--${what} ${tall || editing ? "floor__drawer--tall" : ""}`}
        >
          {what === "plots" ? (
            <PlotsPanel
              source={liveSource}
              tall={tall}
              onTall={(isTall) => {
                drawer.value = { ...drawer.value, tall: isTall };
              }}
            />
          ) : (
            <TextDrawer
              state={drawer.value}
              document={control.open.content.value?.document ?? null}
              running={control.running.value}
              onState={(state) => {
                drawer.value = state;
              }}
              onPlace={(document) => control.replaceBlocks(document)}
            />
          )}
        </div>
      )}
    </div>
  );
}

/** The floor of the live run, or of the moment that the group looks at. */
function StudioFloor({ control }: { control: StudioControl }) {
  const companion = useComputed(
    () =>
      control.ghost.companion.value ?? (control.mine.value ? liveGhost(control.world.value) : null),
  );
  return (
    <Scene
      world={control.world.value}
      robot={control.robot.value}
      livery={liveryOf(group.value)}
      view={shown}
      poseAt={shownPose}
      whole={robot.live}
      companion={companion}
      bundle={control.cloud.bundle}
      onPath={control.runRobot}
      hold={control.hold}
      playing={isNow}
      solved={useSolved(control)}
    />
  );
}

function Corner({ control }: { control: StudioControl }) {
  const busy = useComputed(() => isLive(robot.live.value));
  const own = control.open.ownWorld.now.value;
  const labels = texts.value.world;
  const { mission } = control.worlds;
  if (chosenRobot.value) return <RoomCorner control={control} />;
  if (mission.value) return <MissionCorner control={control} />;
  return (
    <div class="floor__corner">
      <RobotChoice />
      <WorldChoice
        worlds={worlds.value}
        world={control.worlds.name.value}
        busy={busy.value}
        own={own && (worldTitle(own, language.value) || labels.own)}
        onWorld={(name) => control.worlds.choose(name)}
      />
      <Button
        class="floor__change"
        icon={Pencil}
        tip={labels.changeHelp}
        testId="world-change"
        disabled={busy.value || !control.world.value}
        onPress={() => control.worlds.edit()}
      >
        {labels.change}
      </Button>
      <MuteButton view={robot.live} expected={control.beeps.value} live />
    </div>
  );
}

/** Corner of the floor for a real robot, which drives in its room: no world to choose. */
function RoomCorner({ control }: { control: StudioControl }) {
  return (
    <div class="floor__corner">
      <RobotChoice />
      <RoomStatus />
      <PredictionSwitch isSmall robot={livePrediction.value?.robot} />
      <MuteButton view={robot.live} expected={control.beeps.value} live />
    </div>
  );
}

/** The room, and the state of a detected robot: the header shows this state in wide windows only. */
function RoomStatus() {
  const { value: link } = activeRealLink;
  const state = link ? robotStates.value[link] : undefined;
  const isDetected = state?.state === "connected" || state?.state === "silent";
  const { short, tip } = stateText(state);
  return (
    <p class="floor__locked floor__room row middle gap-2" title={isDetected ? tip : undefined}>
      <span class="floor__room-name">{texts.value.robot.room}</span>
      {isDetected && <span class="floor__robot-state">{short}</span>}
    </p>
  );
}

/** Corner of the floor for a mission, which determines the world. */
function MissionCorner({ control }: { control: StudioControl }) {
  const { world } = control.worlds;
  return (
    <div class="floor__corner">
      <RobotChoice />
      <p
        class="floor__locked row middle gap-2"
        title={texts.value.activity.locked}
        data-testid="world-locked"
      >
        <Lock class="icon" aria-hidden="true" />
        {world.value && worldTitle(world.value, language.value)}
        <span class="visually-hidden">{texts.value.activity.locked}</span>
      </p>
      <MuteButton view={robot.live} expected={control.beeps.value} live />
    </div>
  );
}

function Asked({ control, question }: { control: StudioControl; question: Question }) {
  return (
    <QuestionPanel
      question={question}
      onAnswer={(value) => control.send({ do: "answer", value })}
    />
  );
}

function CaptureWhileAsked({ control }: { control: StudioControl }) {
  const { capture } = robot.live.value;
  if (!capture) return null;
  return (
    <CapturePanel
      capture={capture}
      expected={control.expectedSigns.value}
      besideFloor={(control.world.value?.zones.length ?? 0) > 0}
      onAnswer={(result) => control.send({ do: "answer_capture", result })}
    />
  );
}
