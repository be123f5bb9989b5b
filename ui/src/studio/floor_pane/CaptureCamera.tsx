import { ArrowLeftRight } from "lucide-preact";
import type { CaptureOf } from "../../api/model";
import { CameraPicture } from "../../camera/CameraPicture";
import { CurrentSign } from "../../camera/CurrentSign";
import { drawnHand } from "../../camera/drawn_hand";
import { hasDrawing, SignDrawing } from "../../camera/SignDrawing";
import { hasPicture, sight } from "../../camera/sight";
import { type SignState, signStateOf } from "../../camera/sign_state";
import { texts } from "../../i18n";
import { namedSign } from "../../i18n/phrases";
import { Button } from "../../kit/Button";

interface CaptureCameraProps {
  what: CaptureOf;
  /** The signs that the program compares the answer with. */
  expected: readonly string[];
  onAnswer(result: string): void;
}

/** The camera's picture and prediction while the program waits for a sign, and the expected signs. */
export function CaptureCamera({ what, expected, onAnswer }: CaptureCameraProps) {
  const signState = signStateOf(sight.value);
  const { number, progress } = sight.value ?? {};
  return (
    <div class="capture__camera">
      <div class="capture__picture">
        <CameraPicture />
      </div>
      <div
        class="capture__seen column shrinks gap-1"
        hidden={!hasPicture.value && expected.length === 0}
      >
        <CurrentSign what={what} progress={(number ? number.progress : progress) ?? 0} />
        {expected.length > 0 && (
          <Expected signs={expected} signState={signState} onAnswer={onAnswer} />
        )}
      </div>
    </div>
  );
}

interface ExpectedProps {
  signs: readonly string[];
  signState: SignState;
  onAnswer(result: string): void;
}

/** Buttons of the expected signs, which answer too; the last button mirrors the drawings to the other hand. */
function Expected({ signs, signState, onAnswer }: ExpectedProps) {
  const { camera } = texts.value;
  const detected = signState.kind === "sure" ? signState.best : null;
  const hand = drawnHand.value;
  return (
    <div class="expected">
      <p class="expected__title aside">{camera.expected}</p>
      <div class="expected__row row shrinks gap-1">
        <ul class="expected__signs row grows shrinks gap-1">
          {signs.map((sign) => (
            <li key={sign}>
              <Button
                kind="bare"
                class="expected__sign column middle center"
                tip={namedSign(sign, texts.value)}
                testId="expected-sign"
                data-sign={sign}
                data-seen={String(sign === detected)}
                onPress={() => onAnswer(sign)}
              >
                {hasDrawing(sign) && <SignDrawing sign={sign} hand={hand} />}
                <span class="expected__name">{sign}</span>
              </Button>
            </li>
          ))}
        </ul>
        <Button
          kind="plain"
          class="expected__hand"
          icon={ArrowLeftRight}
          label={camera.hands[hand]}
          testId="drawn-hand"
          data-hand={hand}
          onPress={() => {
            drawnHand.value = hand === "right" ? "left" : "right";
          }}
        />
      </div>
    </div>
  );
}
