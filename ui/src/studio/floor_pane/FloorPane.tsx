import { useSignal, useSignalEffect } from "@preact/signals";
import { ChartLine, FileCode } from "lucide-preact";
import { texts } from "../../i18n";
import { FootButton } from "../../kit/FootButton";
import { WayBack } from "../../kit/WayBack";
import * as robot from "../../run/live";
import { Readout } from "../../run/panels/Readout";
import { StatusLine } from "../../run/panels/StatusLine";
import { TEST } from "../../shell/testids";
import { Controls } from "../run_bar/Controls";
import type { StudioControl } from "../studio_control";
import { DRAWER, type DrawerState } from "../text/drawer";
import { prepareCapture } from "./CapturePanel";
import { Stage } from "./Stage";

export function FloorPane({ control }: { control: StudioControl }) {
  const drawer = useSignal(DRAWER);
  useSignalEffect(() => {
    if (control.captures.value) prepareCapture();
  });
  const { open, what, editing } = drawer.value;
  const { python, plots } = texts.value;
  // unsaved Python text must not be discarded
  const busy = open && editing;
  const show = (wanted: DrawerState["what"]) => {
    drawer.value = { ...drawer.value, what: wanted, open: !open || what !== wanted };
  };
  return (
    <section class="floor" aria-label={texts.value.studio.floor}>
      <Controls control={control} />
      <Status control={control} />
      <Forgotten control={control} />
      <Stage control={control} drawer={drawer} />
      <div class="floor__foot card">
        <Readout view={robot.live} />
        <FootButton
          testId={TEST.plotsToggle}
          icon={ChartLine}
          word={plots.open}
          label={plots.label}
          open={open && what === "plots"}
          disabled={busy}
          onPress={() => show("plots")}
        />
        <FootButton
          testId={TEST.irToggle}
          icon={FileCode}
          word={python.short}
          label={python.open}
          open={open && what === "text"}
          disabled={busy}
          onPress={() => show("text")}
        />
      </div>
    </section>
  );
}

function Status({ control }: { control: StudioControl }) {
  return <StatusLine sentence={control.sentence.value} />;
}

/** Offers undo after the group's own world was deleted. */
function Forgotten({ control: { worlds } }: { control: StudioControl }) {
  const { world } = texts.value;
  if (!worlds.forgotten.value) return null;
  return (
    <WayBack
      words={world.forgotten}
      action={world.bringBack}
      testId={TEST.worldBringBack}
      onBack={() => worlds.bringBack()}
      onClose={() => {
        worlds.forgotten.value = null;
      }}
    />
  );
}
