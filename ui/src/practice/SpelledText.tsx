import { Delete, Eraser, Space, Undo2 } from "lucide-preact";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import type { Spelling } from "./spelling";

/** Maximum length of the text, in characters; more than a short sentence needs. */
const MAX_LENGTH = 200;

/** The spelled text; it can also be edited with the keyboard. */
export function SpelledText({ spelling }: { spelling: Spelling }) {
  const labels = texts.value.practice;
  const text = spelling.text.value;
  const isEmpty = text === "";
  return (
    <section class="spelled" aria-label={labels.text}>
      <input
        class="field spelled__text"
        value={text}
        maxLength={MAX_LENGTH}
        autoComplete="off"
        spellcheck={false}
        aria-label={labels.text}
        placeholder={labels.placeholder}
        data-testid="practice-text"
        onInput={(event) => spelling.write(event.currentTarget.value)}
      />
      <Button icon={Space} testId="practice-space" onPress={() => spelling.write(`${text} `)}>
        {labels.space}
      </Button>
      <Button
        icon={Delete}
        testId="practice-back"
        disabled={isEmpty}
        onPress={() => spelling.back()}
      >
        {labels.back}
      </Button>
      <ClearButton spelling={spelling} />
      <p class="spelled__note aside">
        <span>{labels.moving}</span>
        <span>{labels.credits}</span>
      </p>
      <p class="visually-hidden" role="status">
        {text}
      </p>
    </section>
  );
}

/** Clears the text, or restores it after clearing. */
function ClearButton({ spelling }: { spelling: Spelling }) {
  const labels = texts.value.practice;
  const wasCleared = spelling.cleared.value !== "";
  return (
    <Button
      icon={wasCleared ? Undo2 : Eraser}
      testId="practice-clear"
      disabled={!wasCleared && spelling.text.value === ""}
      onPress={() => (wasCleared ? spelling.bringBack() : spelling.clear())}
    >
      {wasCleared ? labels.bringBack : labels.clear}
    </Button>
  );
}
