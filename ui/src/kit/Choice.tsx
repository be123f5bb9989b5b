import { Button, type ButtonProps } from "./Button";
import type { Option, Words } from "./option";

export type ChoiceOption<T> = Option<T, Words, Partial<ButtonProps>>;

interface ChoiceProps<T> {
  label: string;
  /** Makes the label visible, with this class. */
  legendClass?: string;
  value: T;
  options: readonly ChoiceOption<T>[];
  onChange(value: T): unknown;
  class?: string;
  optionClass?: string;
  testId?: string;
}

/** A radio group. */
export function Choice<T extends string | number | boolean | null>(props: ChoiceProps<T>) {
  const { label, legendClass, value, options, onChange, testId } = props;
  return (
    <fieldset class={props.class ?? "choice"} aria-label={legendClass ? undefined : label}>
      {legendClass && <legend class={legendClass}>{label}</legend>}
      {options.map(([option, words, more]) => (
        <Button
          key={String(option)}
          data-value={String(option)}
          {...more}
          class={props.optionClass ?? "choice__option"}
          testId={testId}
          pressed={option === value}
          onPress={() => onChange(option)}
        >
          {words}
        </Button>
      ))}
    </fieldset>
  );
}
