import type { InputHTMLAttributes } from "preact";
import { useId, useRef } from "preact/hooks";
import type { AppearanceProps } from "./appearance";
import { Button } from "./Button";
import { settled } from "./report";

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

interface FileButtonProps extends AppearanceProps {
  /** Extensions or types of the files to choose from. */
  accept: string;
  /** May return a promise; its failure is reported. */
  onFile(file: File): unknown;
}

/** A button that opens the file dialog. The test id is on the input. */
export function FileButton({ accept, testId, onFile, ...face }: FileButtonProps) {
  const input = useRef<HTMLInputElement>(null);
  return (
    <>
      <input
        ref={input}
        type="file"
        accept={accept}
        hidden
        data-testid={testId}
        onChange={({ currentTarget }) => {
          const [file] = currentTarget.files ?? [];
          currentTarget.value = ""; // lets the user choose the same file again
          if (file) void settled(onFile(file));
        }}
      />
      <Button {...face} onPress={() => input.current?.click()} />
    </>
  );
}
