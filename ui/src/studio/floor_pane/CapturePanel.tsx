import { Hand } from "lucide-preact";
import { useLayoutEffect } from "preact/hooks";
import { language, texts } from "../../i18n";
import { decimal } from "../../i18n/format";
import { Button } from "../../kit/Button";
import { listenForKeys } from "../../kit/listen";
import type { Capture } from "../../run/reducer";
import { TEST } from "../../shell/testids";

/** The static letters of the LIBRAS alphabet; both signs for D are one letter. */
export const LETTERS = [..."ABCDEFGIKLMNOPQRSTUVW"];

interface CapturePanelProps {
  capture: Capture;
  onAnswer(result: string): void;
}

/** Asks for a sign; without a camera the group chooses its letter. */
export function CapturePanel({ capture, onAnswer }: CapturePanelProps) {
  const words = texts.value.capture;
  useLayoutEffect(() => listenForLetters(onAnswer));
  const shown = decimal(Math.ceil(capture.leftS), 0, language.value);
  return (
    <section class="capture" aria-label={words.title} data-testid={TEST.capture}>
      <div class="capture__head">
        <Hand class="icon capture__hand" aria-hidden="true" />
        <div>
          <h2>{words.title}</h2>
          <p>{words.hint}</p>
        </div>
        <span class="capture__left" role="timer" aria-label={words.leftHelp(shown)}>
          {words.left(shown)}
        </span>
      </div>
      <div class="capture__bar" aria-hidden="true">
        <div style={{ width: `${(100 * capture.leftS) / capture.timeoutS}%` }} />
      </div>
      <div class="capture__letters">
        {LETTERS.map((letter) => (
          <Answer key={letter} result={letter} label={words.letter(letter)} onAnswer={onAnswer}>
            {letter}
          </Answer>
        ))}
        <Answer result="" label={words.noneHelp} onAnswer={onAnswer}>
          {words.none}
        </Answer>
      </div>
    </section>
  );
}

/** Letter keys answer too, unless another element has the keyboard focus. */
function listenForLetters(onAnswer: (result: string) => void): () => void {
  return listenForKeys((key) => {
    const letter = key.toUpperCase();
    const isLetter = LETTERS.includes(letter);
    if (isLetter) onAnswer(letter);
    return isLetter;
  });
}

interface AnswerProps {
  result: string;
  label: string;
  children: string;
  onAnswer(result: string): void;
}

function Answer({ result, label, children, onAnswer }: AnswerProps) {
  return (
    <Button
      class={`capture__letter ${result === "" ? "capture__none" : ""}`}
      label={label}
      testId={TEST.captureLetter}
      data-letter={result}
      onPress={() => onAnswer(result)}
    >
      {children}
    </Button>
  );
}
