import type { CaptureOf } from "../api/model";
import { type Texts, texts } from "../i18n";
import { namedSign } from "../i18n/phrases";
import { CameraTrouble } from "./CameraTrouble";
import { SignStateView, type StateLabels } from "./SignStateView";
import { camera, hasPicture, sight } from "./sight";
import { numberStateOf, signStateOf } from "./sign_state";

interface CurrentSignProps {
  /** Fraction of the hold time that has passed, 0 to 1. */
  progress: number;
  /** Instruction while a sign is held; by default, to hold it still. */
  next?: string | undefined;
  /** What is looked for: a sign, or the number of raised fingers. */
  what?: CaptureOf;
}

/** The currently detected sign or number; without one, the problem of the picture. */
export function CurrentSign({ progress, next, what = "sign" }: CurrentSignProps) {
  const { problem } = camera.value;
  const state = what === "number" ? numberStateOf(sight.value) : signStateOf(sight.value);
  const labels = labelsOf(what, texts.value);
  if (!hasPicture.value) return null;
  if (problem && !("best" in state)) return <CameraTrouble problem={problem} />;
  return (
    <SignStateView state={state} labels={labels} progress={progress} next={next ?? labels.hold} />
  );
}

function labelsOf(what: CaptureOf, all: Texts): StateLabels {
  const of = all.camera;
  if (what === "sign") return { ...of, called: (sign) => namedSign(sign, all) };
  const { noNumber: noLetter, unsureNumber: unsure, showHands: showHand, holdHands: hold } = of;
  const called = (number: string) => all.sign.number({ number });
  return { ...of, noLetter, unsure, showHand, hold, called };
}
