import { useComputed, useSignal, useSignalEffect } from "@preact/signals";
import { ChartLine, FileCode } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { texts } from "../../i18n";
import { PanelToggle } from "../../kit/PanelToggle";
import { UndoBanner } from "../../kit/UndoBanner";
import { livePrediction } from "../../prediction/live_prediction";
import { PredictionLine } from "../../prediction/PredictionLine";
import { shown } from "../../run/inspected_tick";
import * as robot from "../../run/live";
import { Readout } from "../../run/panels/Readout";
import { StatusLine } from "../../run/panels/StatusLine";
import { chosenRobot } from "../../run/real/real_robot";
import { isLive } from "../../run/reducer";
import { helpIsOpen } from "../../shell/help";
import { lazy } from "../../shell/lazy";
import { CloudLine } from "../cloud/CloudLine";
import { BeforeRun } from "../real_robot/BeforeRun";
import { Controls } from "../run_bar/Controls";
import type { StudioControl } from "../studio_control";
import { DRAWER, type DrawerState } from "../text/drawer";
import { prepareCapture } from "./CapturePanel";
import { Stage } from "./Stage";

const LastRunTimeline = lazy(async () => (await import("./LastRunTimeline")).LastRunTimeline);
const AfterRun = lazy(async () => (await import("../../truth/AfterRun")).AfterRun);
const SourceTrouble = lazy(async () => (await import("../../truth/SourceTrouble")).SourceTrouble);
const HelpPanel = lazy(async () => (await import("../help/HelpPanel")).HelpPanel);

export function FloorPane({ control }: { control: StudioControl }) {
  const drawer = useSignal(DRAWER);
  useSignalEffect(() => (control.captures.value ? prepareCapture() : undefined));
  // the help replaces the floor, so a run closes the help
  useSignalEffect(() => {
    if (robot.isRunning.value) helpIsOpen.value = false;
  });
  useEffect(
    () => () => {
      helpIsOpen.value = false;
    },
    [],
  );
  const { open, what, editing } = drawer.value;
  const { python, plots } = texts.value;
  // unsaved Python text must not be discarded
  const busy = open && editing;
  const show = (requested: DrawerState["what"]) => {
    drawer.value = { ...drawer.value, what: requested, open: !open || what !== requested };
  };
  return (
    <section class="floor column shrinks shrinks-down gap-2" aria-label={texts.value.studio.floor}>
      <Controls control={control} />
      <Status control={control} />
      <Predicted control={control} />
      {control.mine.value && chosenRobot.value && <SourceTrouble />}
      <Robots control={control} />
      <BeforeRun control={control} />
      {control.mine.value && chosenRobot.value && <AfterRun />}
      <Forgotten control={control} />
      {helpIsOpen.value && <HelpPanel control={control} />}
      <Stage control={control} drawer={drawer} />
      <RunTime control={control} />
      <div class="floor__foot card">
        <Readout view={shown} />
        <PanelToggle
          testId="plots-toggle"
          icon={ChartLine}
          text={plots.open}
          label={plots.label}
          open={open && what === "plots"}
          disabled={busy}
          onPress={() => show("plots")}
        />
        <PanelToggle
          testId="ir-toggle"
          icon={FileCode}
          text={python.short}
          label={python.open}
          open={open && what === "text"}
          disabled={busy}
          onPress={() => show("text")}
        />
      </div>
    </section>
  );
}

/** What the robot does. Before a run, the sentence about the 50 robots stands alone, for the sake of the floor. */
function Status({ control }: { control: StudioControl }) {
  const isBefore = useComputed(() => !control.mine.value || robot.live.value.phase === "idle");
  const isReplaced = control.cloud.now.value !== null && isBefore.value;
  return isReplaced ? null : <StatusLine sentence={control.sentence.value} />;
}

/** What the 50 robots did. */
function Robots({ control }: { control: StudioControl }) {
  return (
    <CloudLine
      of={control.cloud}
      cases={control.open.mission.value?.cases ?? []}
      onCase={(number) => control.startCloud(number)}
    />
  );
}

/** After a run on a real robot: what it did otherwise than predicted. */
function Predicted({ control }: { control: StudioControl }) {
  const isOver = useComputed(() => control.mine.value && !isLive(robot.live.value));
  const { value: prediction } = livePrediction;
  return isOver.value && prediction ? <PredictionLine prediction={prediction} /> : null;
}

/** Time strip of the last run. Its space is always there, so that the floor keeps its height. */
function RunTime({ control }: { control: StudioControl }) {
  const has = useComputed(() => control.mine.value && robot.live.value.phase !== "idle");
  const over = useComputed(() => !isLive(robot.live.value));
  return (
    <div class={`floor__time row rigid ${has.value ? "" : "floor__no-run"}`}>
      {has.value ? over.value && <LastRunTimeline /> : texts.value.run.noTime}
    </div>
  );
}

/** Offers undo after the group's own world was deleted. */
function Forgotten({ control: { worlds } }: { control: StudioControl }) {
  const { world } = texts.value;
  if (!worlds.forgotten.value) return null;
  return (
    <UndoBanner
      text={world.forgotten}
      action={world.bringBack}
      testId="world-bring-back"
      onBack={() => worlds.bringBack()}
      onClose={() => {
        worlds.forgotten.value = null;
      }}
    />
  );
}
