import { type ReadonlySignal, useComputed } from "@preact/signals";
import { Volume2, VolumeX } from "lucide-preact";
import { TEST } from "../app/testids";
import { texts } from "../i18n";
import type { RunView } from "./reducer";
import { muted, setMuted } from "./sound";

interface MuteButtonProps {
  view: ReadonlySignal<RunView>;
  /** The program may beep, though it has not yet. */
  expected?: boolean;
}

/** Sound on or off; there only where there is something to hear. */
export function MuteButton({ view, expected = false }: MuteButtonProps) {
  const loud = useComputed(() => view.value.output.beeps > 0);
  if (!loud.value && !expected) return null;
  const { show } = texts.value;
  const label = muted.value ? show.unmute : show.mute;
  const Icon = muted.value ? VolumeX : Volume2;
  return (
    <button
      type="button"
      class="button button--icon"
      aria-label={label}
      title={label}
      data-testid={TEST.mute}
      data-muted={muted.value}
      onClick={() => setMuted(!muted.value)}
    >
      <Icon class="icon" aria-hidden="true" />
    </button>
  );
}
