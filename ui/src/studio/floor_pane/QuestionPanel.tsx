import { CircleQuestionMark, Send } from "lucide-preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { language, texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { Form } from "../../kit/Form";
import type { Question } from "../../run/output";
import { localizeNumbers } from "../../run/values";

/** Maximum length of an answer in characters, as in the server. */
const MAX_LENGTH = 1000;

interface QuestionPanelProps {
  question: Question;
  onAnswer(value: string): void;
}

/** Asks the question of the program. */
export function QuestionPanel({ question, onAnswer }: QuestionPanelProps) {
  const labels = texts.value.question;
  const asked = localizeNumbers(question.text, language.value);
  const [value, setValue] = useState("");
  const field = useRef<HTMLInputElement>(null);
  useEffect(() => focusUnlessBusy(field.current), [question]);
  const isBlank = value.trim() === "";
  return (
    <Form
      class="question"
      aria-label={labels.title}
      testId="question"
      onSubmit={() => !isBlank && onAnswer(value)}
    >
      <CircleQuestionMark class="icon question__icon" aria-hidden="true" />
      <div>
        <h2 class="question__title">{labels.title}</h2>
        <p class="question__text" data-testid="question-text">
          {asked}
        </p>
      </div>
      <div class="question__answer row gap-2">
        <input
          class="field"
          ref={field}
          value={value}
          maxLength={MAX_LENGTH}
          autoComplete="off"
          spellcheck={false}
          aria-label={asked}
          placeholder={labels.answer}
          data-testid="answer"
          onInput={(event) => setValue(event.currentTarget.value)}
        />
        <Button
          submit
          kind="main"
          class="question__send"
          icon={Send}
          testId="send-answer"
          disabled={isBlank}
        >
          {labels.send}
        </Button>
      </div>
      <p class="question__hint aside">{labels.keptIn({ variable: question.variable })}</p>
    </Form>
  );
}

/** Focuses the field unless the person is typing or editing blocks. */
function focusUnlessBusy(field: HTMLInputElement | null): void {
  const busy = document.activeElement?.closest("input, textarea, select, .injectionDiv");
  if (!busy) field?.focus();
}
