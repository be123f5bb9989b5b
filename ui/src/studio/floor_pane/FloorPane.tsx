import { useSignal } from "@preact/signals";
import { ChartLine, FileCode } from "lucide-preact";
import { TEST } from "../app/testids";
import { texts } from "../i18n";
import * as robot from "../run/live";
import { Readout } from "../run/Readout";
import { StatusLine } from "../run/StatusLine";
import { DRAWER, type DrawerState } from "../run/text/drawer";
import { Controls } from "./Controls";
import { FootButton } from "./FootButton";
import { Stage } from "./Stage";
import type { StudioControl } from "./studio_control";
import { WayBack } from "./WayBack";

export function FloorPane({ control }: { control: StudioControl }) {
  const drawer = useSignal(DRAWER);
  const { open, what, editing } = drawer.value;
  const { python, plots } = texts.value;
  // what is being written is not thrown away
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
          Icon={ChartLine}
          word={plots.open}
          label={plots.label}
          open={open && what === "plots"}
          disabled={busy}
          onClick={() => show("plots")}
        />
        <FootButton
          testId={TEST.irToggle}
          Icon={FileCode}
          word={python.short}
          label={python.open}
          open={open && what === "text"}
          disabled={busy}
          onClick={() => show("text")}
        />
      </div>
    </section>
  );
}

function Status({ control }: { control: StudioControl }) {
  return <StatusLine sentence={control.sentence.value} />;
}

/** After the group's own world was deleted: the way back. */
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
