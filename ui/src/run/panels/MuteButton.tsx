import { type ReadonlySignal, useComputed } from "@preact/signals";
import { Volume2, VolumeX } from "lucide-preact";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import type { RunView } from "../reducer";
import { muted, setMuted } from "../sound";

interface MuteButtonProps {
  view: ReadonlySignal<RunView>;
  /** The program contains a beep that may not have sounded yet. */
  expected?: boolean;
}

/** Turns sound on or off; hidden if the run makes no sound. */
export function MuteButton({ view, expected = false }: MuteButtonProps) {
  const loud = useComputed(() => view.value.output.beeps.count > 0);
  if (!loud.value && !expected) return null;
  const { show } = texts.value;
  return (
    <Button
      icon={muted.value ? VolumeX : Volume2}
      label={muted.value ? show.unmute : show.mute}
      testId="mute"
      data-muted={muted.value}
      onPress={() => setMuted(!muted.value)}
    />
  );
}
