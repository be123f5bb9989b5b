import { texts } from "../i18n";
import { CameraTrouble } from "./CameraTrouble";
import { SignStateView } from "./SignStateView";
import { camera, hasPicture, sight } from "./sight";
import { signStateOf } from "./sign_state";

interface CurrentSignProps {
  /** How near the sign is to counting, 0 to 1. */
  progress: number;
  /** What to do while a sign is held; without it, to keep it still. */
  next?: string | undefined;
}

/** What the camera sees just now; what is wrong with its picture while it can see no sign in it. */
export function CurrentSign({ progress, next = texts.value.camera.hold }: CurrentSignProps) {
  const { problem } = camera.value;
  const state = signStateOf(sight.value);
  if (!hasPicture.value) return null;
  if (problem && !("best" in state)) return <CameraTrouble problem={problem} />;
  return <SignStateView state={state} progress={progress} next={next} />;
}
