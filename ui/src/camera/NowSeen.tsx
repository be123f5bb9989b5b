import { texts } from "../i18n";
import { CameraTrouble } from "./CameraTrouble";
import { readingOf } from "./reading";
import { SignReading } from "./SignReading";
import { camera, hasPicture, sight } from "./sight";

interface NowSeenProps {
  /** How near the sign is to counting, 0 to 1. */
  progress: number;
  /** What to do while a sign is held; without it, to keep it still. */
  next?: string | undefined;
}

/** What the camera sees just now; what is wrong with its picture while it can see no sign in it. */
export function NowSeen({ progress, next = texts.value.camera.hold }: NowSeenProps) {
  const { problem } = camera.value;
  const reading = readingOf(sight.value);
  if (!hasPicture.value) return null;
  if (problem && !("best" in reading)) return <CameraTrouble problem={problem} />;
  return <SignReading reading={reading} progress={progress} next={next} />;
}
