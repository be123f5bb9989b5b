import { Hand } from "lucide-preact";
import { useLayoutEffect } from "preact/hooks";
import { hasPicture, warmUpRegularly } from "../../camera/sight";
import { listenForSigns } from "../../camera/signs";
import { language, texts } from "../../i18n";
import { decimal } from "../../i18n/format";
import type { Capture } from "../../run/reducer";
import { fetchPart, lazy } from "../../shell/lazy";
import { listenForDigits, NumberAnswers, SignAnswers } from "./SignAnswers";

const load = async () => (await import("./CaptureCamera")).CaptureCamera;
const CaptureCamera = lazy(load);
const CameraChoice = lazy(async () => (await import("../../camera/CameraChoice")).CameraChoice);

/**
 * Starts the camera process and loads its panel before the open program asks for a sign. A failure
 * here is reported only when the panel opens. The returned function lets the process end when idle.
 */
export function prepareCapture(): () => void {
  fetchPart(load).catch(() => {});
  return warmUpRegularly();
}

interface CapturePanelProps {
  capture: Capture;
  /** The signs that the program compares the answer with. */
  expected: readonly string[];
  /** Whether the floor has places to choose from: it stays visible beside the camera's picture. */
  besideFloor?: boolean;
  onAnswer(result: string): void;
}

/**
 * Panel while the program waits for a sign or a number: the camera recognises it, or the group
 * chooses it.
 */
export function CapturePanel(props: CapturePanelProps) {
  const { capture, expected, besideFloor, onAnswer } = props;
  const labels = texts.value.capture;
  const { what } = capture;
  const isNumber = what === "number";
  useLayoutEffect(() => (isNumber ? listenForDigits(onAnswer) : listenForSigns(onAnswer)));
  return (
    <section
      class={`capture column shrinks-down ${hasPicture.value ? "capture--camera" : ""} ${besideFloor ? "capture--beside" : ""}`}
      aria-label={isNumber ? labels.numberTitle : labels.title}
      data-testid="capture"
    >
      <Head capture={capture} />
      <CaptureCamera what={what} expected={isNumber ? [] : expected} onAnswer={onAnswer} />
      {isNumber ? (
        <NumberAnswers onAnswer={onAnswer} />
      ) : (
        <SignAnswers expected={expected} onAnswer={onAnswer} />
      )}
    </section>
  );
}

function Head({ capture: { leftS, timeoutS, what } }: { capture: Capture }) {
  const labels = texts.value.capture;
  const [show, title] =
    what === "number" ? [labels.numberShow, labels.numberTitle] : [labels.show, labels.title];
  const count = Math.ceil(leftS);
  const shown = decimal(count, 0, language.value);
  return (
    <>
      <div class="capture__head row middle gap-3">
        <Hand class="icon capture__hand" aria-hidden="true" />
        <h2 class="capture__title">{hasPicture.value ? show : title}</h2>
        <CameraChoice />
        <span
          class="capture__left"
          role="timer"
          aria-label={labels.leftHelp({ seconds: shown, count })}
        >
          {labels.left({ seconds: shown })}
        </span>
      </div>
      <div class="capture__bar" aria-hidden="true">
        <div style={{ width: `${(100 * leftS) / timeoutS}%` }} />
      </div>
    </>
  );
}
