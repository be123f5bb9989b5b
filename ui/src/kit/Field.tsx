import type { InputHTMLAttributes } from "preact";
import { useId } from "preact/hooks";

interface FieldProps extends InputHTMLAttributes<HTMLInputElement> {
  label: string;
  hint?: string;
  value: string;
  onText(text: string): void;
}

/** A text field with its label above and a hint below. */
export function Field({ label, hint, onText, ...rest }: FieldProps) {
  const id = useId();
  return (
    <div class="labelled">
      <label class="labelled__label" for={id}>
        {label}
      </label>
      <input
        {...rest}
        id={id}
        class="field"
        autocomplete="off"
        spellcheck={false}
        aria-describedby={hint ? `${id}-hint` : undefined}
        onInput={(event) => onText(event.currentTarget.value)}
      />
      {hint && (
        <p class="labelled__hint" id={`${id}-hint`}>
          {hint}
        </p>
      )}
    </div>
  );
}

/** A field for the PIN; the digits are hidden. */
export function PinField(props: FieldProps) {
  return <Field {...props} type="password" inputMode="numeric" maxLength={12} />;
}
