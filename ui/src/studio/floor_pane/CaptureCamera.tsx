import { CameraPicture } from "../../camera/CameraPicture";
import { NowSeen } from "../../camera/NowSeen";
import { type Reading, readingOf } from "../../camera/reading";
import { SignDrawing } from "../../camera/SignDrawing";
import { hasPicture, sight } from "../../camera/sight";
import { texts } from "../../i18n";
import { TEST } from "../../shell/testids";

/** What the camera sees while the program waits for a sign, and the signs that the program knows what to do with. */
export function CaptureCamera({ expected }: { expected: readonly string[] }) {
  const reading = readingOf(sight.value);
  return (
    <div class="capture__camera">
      <div class="capture__picture">
        <CameraPicture />
      </div>
      <div class="capture__seen" hidden={!hasPicture.value && expected.length === 0}>
        <NowSeen progress={sight.value?.progress ?? 0} />
        {expected.length > 0 && <Expected signs={expected} reading={reading} />}
      </div>
    </div>
  );
}

interface ExpectedProps {
  signs: readonly string[];
  reading: Reading;
}

function Expected({ signs, reading }: ExpectedProps) {
  const seen = reading.kind === "sure" ? reading.best : null;
  return (
    <div class="expected">
      <p class="expected__title">{texts.value.camera.expected}</p>
      <ul class="expected__signs">
        {signs.map((sign) => (
          <li
            key={sign}
            class="expected__sign"
            data-testid={TEST.expectedSign}
            data-sign={sign}
            data-seen={String(sign === seen)}
          >
            <SignDrawing sign={sign} />
            <span aria-hidden="true">{sign}</span>
          </li>
        ))}
      </ul>
    </div>
  );
}
