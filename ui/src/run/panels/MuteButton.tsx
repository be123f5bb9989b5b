import { type ReadonlySignal, useComputed } from "@preact/signals";
import { Volume2, VolumeX } from "lucide-preact";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import type { RunView } from "../reducer";
import { isSoundTurnedOn, muted, setMuted } from "../sounds/sound";

interface MuteButtonProps {
  view: ReadonlySignal<RunView>;
  /** The program contains a beep that may not have sounded yet. */
  expected?: boolean;
  /** The run is live: it has sounds besides the beep, which are off until somebody turns them on. */
  live?: boolean;
}

/** Turns sound on or off; hidden if the run makes no sound. */
export function MuteButton({ view, expected = false, live = false }: MuteButtonProps) {
  const beeped = useComputed(() => view.value.output.beeps.count > 0);
  const beeps = beeped.value || expected;
  if (!beeps && !live) return null;
  const { show } = texts.value;
  const isOn = isSoundTurnedOn.value || (beeps && !muted.value);
  return (
    <Button
      icon={isOn ? Volume2 : VolumeX}
      label={isOn ? show.mute : show.unmute}
      testId="mute"
      data-muted={!isOn}
      onPress={() => setMuted(isOn)}
    />
  );
}
