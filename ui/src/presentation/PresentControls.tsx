import {
  Box,
  Contrast,
  Keyboard,
  type LucideIcon,
  Moon,
  Pause,
  Play,
  StepBack,
  StepForward,
  UserRound,
  X,
} from "lucide-preact";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import type { Playback } from "../run/playback";
import { isSolid } from "../scene/tools/view_mode";
import { nextTheme, setTheme, theme } from "../shell/theme";
import type { Action } from "./keys";
import { isNameless } from "./names";

interface PresentControlsProps {
  /** The clock of the runs; null for a program. */
  playback: Playback | null;
  onAction(action: Action): void;
}

/** What the keys do, for a mouse. */
export function PresentControls({ playback, onAction }: PresentControlsProps) {
  const { projector, replay, header, solid } = texts.value;
  const isPlaying = playback?.playing.value;
  const control = (action: Action, icon: LucideIcon, label: string, pressed?: boolean) => (
    <Button
      icon={icon}
      kind="plain"
      label={label}
      pressed={pressed}
      testId="presentation-control"
      data-action={action}
      onPress={() => onAction(action)}
    />
  );
  return (
    <div class="presentation__controls row rigid" role="toolbar" aria-label={projector.controls}>
      {control("previous", StepBack, replay.back)}
      {playback &&
        control("play", isPlaying ? Pause : Play, isPlaying ? replay.pause : replay.play)}
      {control("next", StepForward, replay.forward)}
      {control("names", UserRound, projector.names, !isNameless.value)}
      {playback && control("solid", Box, solid.solidTip, isSolid.value)}
      {control("black", Moon, projector.black)}
      <Button
        icon={Contrast}
        kind="plain"
        label={header.changeTheme({ now: header.theme[theme.value] })}
        testId="theme"
        onPress={() => setTheme(nextTheme(theme.value))}
      />
      {control("help", Keyboard, projector.keys)}
      {control("leave", X, projector.leave)}
    </div>
  );
}
