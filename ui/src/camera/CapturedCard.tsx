import { language, type Texts, texts } from "../i18n";
import type { CaptureShow } from "../run/captures/capture_show";
import { captureText } from "../run/captures/captured";
import type { CaptureAnswer } from "../run/reducer";
import { drawnHand } from "./drawn_hand";
import { SignDrawing } from "./SignDrawing";

/** What a capture got, large, while it is shown: the sign's hand and its name. The status line announces it. */
export function CapturedCard({ show }: { show: CaptureShow }) {
  const answer = show.now.value;
  if (!answer) return null;
  return (
    <div class="captured column middle center" data-testid="captured" data-sign={answer.label}>
      {answer.label && <SignDrawing sign={answer.label} hand={drawnHand.value} />}
      <p class="captured__text">{shortText(answer, texts.value)}</p>
    </div>
  );
}

/** What the robot says of an answer; of one that no camera gave, the same as in the status line. */
function shortText(answer: CaptureAnswer, all: Texts): string {
  const { what, label: sign, by } = answer;
  const { captured } = all;
  if (sign === "" || by === "person" || by === "list") {
    return captureText(answer, all, language.value);
  }
  if (what === "number") return captured.number({ number: sign });
  return sign.length === 1 ? captured.letter({ sign }) : captured.sign({ sign });
}
