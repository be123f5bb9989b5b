import { ArrowLeftRight } from "lucide-preact";
import { CameraPicture } from "../../camera/CameraPicture";
import { drawnHand } from "../../camera/drawn_hand";
import { NowSeen } from "../../camera/NowSeen";
import { type Reading, readingOf } from "../../camera/reading";
import { hasDrawing, SignDrawing } from "../../camera/SignDrawing";
import { hasPicture, sight } from "../../camera/sight";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";

interface CaptureCameraProps {
  /** The signs that the program compares the answer with. */
  expected: readonly string[];
  onAnswer(result: string): void;
}

/** What the camera sees while the program waits for a sign, and the signs that the program knows what to do with. */
export function CaptureCamera({ expected, onAnswer }: CaptureCameraProps) {
  const reading = readingOf(sight.value);
  return (
    <div class="capture__camera">
      <div class="capture__picture">
        <CameraPicture />
      </div>
      <div
        class="capture__seen column shrinks gap-1"
        hidden={!hasPicture.value && expected.length === 0}
      >
        <NowSeen progress={sight.value?.progress ?? 0} />
        {expected.length > 0 && <Expected signs={expected} reading={reading} onAnswer={onAnswer} />}
      </div>
    </div>
  );
}

interface ExpectedProps {
  signs: readonly string[];
  reading: Reading;
  onAnswer(result: string): void;
}

/** Each is a way to answer too; the last button turns the drawings to the other hand. */
function Expected({ signs, reading, onAnswer }: ExpectedProps) {
  const { camera, capture } = texts.value;
  const seen = reading.kind === "sure" ? reading.best : null;
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
                tip={capture.answer(sign)}
                testId="expected-sign"
                data-sign={sign}
                data-seen={String(sign === seen)}
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
