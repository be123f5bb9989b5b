import { texts } from "../i18n";
import { CameraTrouble } from "./CameraTrouble";
import { SignStateView } from "./SignStateView";
import { camera, hasPicture, sight } from "./sight";
import { signStateOf } from "./sign_state";

interface CurrentSignProps {
  /** Fraction of the hold time that has passed, 0 to 1. */
  progress: number;
  /** Instruction while a sign is held; by default, to hold it still. */
  next?: string | undefined;
}

/** The currently detected sign; without one, the problem of the picture. */
export function CurrentSign({ progress, next = texts.value.camera.hold }: CurrentSignProps) {
  const { problem } = camera.value;
  const state = signStateOf(sight.value);
  if (!hasPicture.value) return null;
  if (problem && !("best" in state)) return <CameraTrouble problem={problem} />;
  return <SignStateView state={state} progress={progress} next={next} />;
}
