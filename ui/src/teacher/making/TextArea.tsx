import { useId } from "preact/hooks";

/** Maximum length of an activity's text in characters, as in pinel_desktop/activities/model.py. */
const MAX_LENGTH = 1000;

interface TextAreaProps {
  label: string;
  value: string;
  placeholder?: string;
  rows?: number;
  testId?: string;
  onText(text: string): void;
}

/** A field for a text of several lines, with its label above. */
export function TextArea({ label, value, placeholder, rows = 2, testId, onText }: TextAreaProps) {
  const id = useId();
  return (
    <div class="labelled">
      <label class="labelled__label" for={id}>
        {label}
      </label>
      <textarea
        id={id}
        class="field making__text"
        rows={rows}
        maxLength={MAX_LENGTH}
        placeholder={placeholder}
        value={value}
        data-testid={testId}
        onInput={({ currentTarget }) => onText(currentTarget.value)}
      />
    </div>
  );
}
