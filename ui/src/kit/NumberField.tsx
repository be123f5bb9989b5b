import { useSignal } from "@preact/signals";
import { useId } from "preact/hooks";
import { language, texts } from "../i18n";

interface NumberFieldProps {
  label: string;
  value: number;
  min: number;
  max: number;
  step: number;
  testId: string;
  onNumber(value: number): void;
}

/** A number field. Invalid text stays in it for correction, with the error below. */
export function NumberField(props: NumberFieldProps) {
  const { label, value, min, max, step, testId, onNumber } = props;
  const id = useId();
  const typed = useSignal<string | null>(null);
  const format = (number: number) => written(number, language.value);
  const read = typed.value === null ? value : numberIn(typed.value);
  const isFault = read === null || read < min || read > max;
  const handleInput = (text: string) => {
    typed.value = text;
    const number = numberIn(text);
    if (number !== null && number >= min && number <= max && number !== value) onNumber(number);
  };
  const nudge = (direction: number) => {
    const number = Math.round((value + direction * step) * 1000) / 1000;
    typed.value = null;
    if (number >= min && number <= max) onNumber(number);
  };
  return (
    <div class="number">
      <label for={id}>{label}</label>
      <input
        id={id}
        class="field number__input"
        inputMode="decimal"
        autocomplete="off"
        value={typed.value ?? format(value)}
        aria-invalid={isFault}
        aria-describedby={isFault ? `${id}-fault` : undefined}
        data-testid={testId}
        data-value={value}
        onInput={({ currentTarget }) => handleInput(currentTarget.value)}
        onBlur={() => {
          if (!isFault) typed.value = null;
        }}
        onKeyDown={(event) => {
          const direction = { ArrowUp: 1, ArrowDown: -1 }[event.key];
          if (direction === undefined) return;
          event.preventDefault();
          nudge(direction);
        }}
      />
      {isFault && (
        <p class="number__fault" id={`${id}-fault`} role="alert">
          {texts.value.world.between({ least: format(min), most: format(max) })}
        </p>
      )}
    </div>
  );
}

/** Parses a number with a decimal comma or point; null if invalid. */
export function numberIn(text: string): number | null {
  const plain = text.trim().replace(",", ".").replace("\u2212", "-");
  if (!/^[-+]?(\d+\.?\d*|\.\d+)$/.test(plain)) return null;
  return Math.round(Number(plain) * 1000) / 1000;
}

const written = (value: number, locale: string) =>
  value.toLocaleString(locale, { maximumFractionDigits: 3, useGrouping: false });
