import { useSignal } from "@preact/signals";
import { FileCode } from "lucide-preact";
import { TEST } from "../app/testids";
import { texts } from "../i18n";
import * as robot from "../run/live";
import { Readout } from "../run/Readout";
import { StatusLine } from "../run/StatusLine";
import { DRAWER } from "../run/text/TextDrawer";
import { Controls } from "./Controls";
import { Stage } from "./Stage";
import type { StudioControl } from "./studio_control";
import "../run/run.css";

export function FloorPane({ control }: { control: StudioControl }) {
  const drawer = useSignal(DRAWER);
  const { open, editing } = drawer.value;
  return (
    <section class="floor" aria-label={texts.value.studio.floor}>
      <Controls control={control} />
      <Status control={control} />
      <Stage control={control} drawer={drawer} />
      <div class="floor__foot card">
        <Readout view={robot.live} />
        <button
          type="button"
          class="button button--plain floor__ir"
          data-testid={TEST.irToggle}
          aria-expanded={open}
          // what is being written is not thrown away
          disabled={open && editing}
          onClick={() => {
            drawer.value = { ...drawer.value, open: !open };
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
