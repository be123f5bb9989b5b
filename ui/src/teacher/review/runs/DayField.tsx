import { useSignal } from "@preact/signals";
import { useId } from "preact/hooks";
import { language, texts } from "../../../i18n";
import { dayText, readDay } from "./day_text";

interface DayFieldProps {
  /** "2026-11-18", or "" for every day. */
  value: string;
  onDay(day: string): void;
}

/** A day, in the language of the page: the browser's own field has the language of the PC. */
export function DayField({ value, onDay }: DayFieldProps) {
  const { day, dayForm, dayFault } = texts.value.review.runs;
  const id = useId();
  const fault = useSignal<string | null>(null);
  const finish = (text: string) => {
    const read = text.trim() ? readDay(text, language.value) : "";
    fault.value = read === null ? text : null;
    if (read !== null && read !== value) onDay(read);
  };
  return (
    <label class="filters__one">
      <span>{day}</span>
      <input
        class="filters__day"
        inputMode="numeric"
        autocomplete="off"
        placeholder={dayForm}
        value={fault.value ?? dayText(value, language.value)}
        aria-invalid={fault.value !== null}
        aria-describedby={fault.value === null ? undefined : id}
        data-testid="history-filter"
        data-name="day"
        data-on={value !== ""}
        onChange={({ currentTarget }) => finish(currentTarget.value)}
      />
      {fault.value !== null && (
        <span class="filters__fault" id={id} role="alert">
          {dayFault({ example: dayText("2026-11-18", language.value) })}
        </span>
      )}
    </label>
  );
}
