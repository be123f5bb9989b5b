import { useSignal } from "@preact/signals";
import { useId } from "preact/hooks";
import { language, texts } from "../i18n";

interface NumberFieldProps {
  label: string;
  value: number;
  least: number;
  most: number;
  step: number;
  testId: string;
  onNumber(value: number): void;
}

/** A number field; an invalid text stays in it for correction, with the error below. */
export function NumberField(props: NumberFieldProps) {
  const { label, value, least, most, step, testId, onNumber } = props;
  const id = useId();
  const typed = useSignal<string | null>(null);
  const tell = (number: number) => written(number, language.value);
  const read = typed.value === null ? value : numberIn(typed.value);
  const isFault = read === null || read < least || read > most;
  const take = (text: string) => {
    typed.value = text;
    const number = numberIn(text);
    if (number !== null && number >= least && number <= most && number !== value) onNumber(number);
  };
  const nudge = (way: number) => {
    const number = Math.round((value + way * step) * 1000) / 1000;
    typed.value = null;
    if (number >= least && number <= most) onNumber(number);
  };
  return (
    <div class="number">
      <label for={id}>{label}</label>
      <input
        id={id}
        class="field number__input"
        inputMode="decimal"
        autocomplete="off"
        value={typed.value ?? tell(value)}
        aria-invalid={isFault}
        aria-describedby={isFault ? `${id}-fault` : undefined}
        data-testid={testId}
        data-value={value}
        onInput={({ currentTarget }) => take(currentTarget.value)}
        onBlur={() => {
          if (!isFault) typed.value = null;
        }}
        onKeyDown={(event) => {
          const way = { ArrowUp: 1, ArrowDown: -1 }[event.key];
          if (way === undefined) return;
          event.preventDefault();
          nudge(way);
        }}
      />
      {isFault && (
        <p class="number__fault" id={`${id}-fault`} role="alert">
          {texts.value.world.between(tell(least), tell(most))}
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
