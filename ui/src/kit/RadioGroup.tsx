import { Button, type ButtonProps } from "./Button";
import type { LabelContent, Option } from "./option";

export type RadioOption<T> = Option<T, LabelContent, Partial<ButtonProps>>;

interface RadioGroupProps<T> {
  label: string;
  /** Makes the label visible, with this class. */
  legendClass?: string;
  value: T;
  options: readonly RadioOption<T>[];
  onChange(value: T): unknown;
  class?: string;
  optionClass?: string;
  testId?: string;
}

/** A radio group. */
export function RadioGroup<T extends string | number | boolean | null>(props: RadioGroupProps<T>) {
  const { label, legendClass, value, options, onChange, testId } = props;
  return (
    <fieldset class={props.class ?? "choice"} aria-label={legendClass ? undefined : label}>
      {legendClass && <legend class={legendClass}>{label}</legend>}
      {options.map(([option, text, more]) => (
        <Button
          key={String(option)}
          data-value={String(option)}
          {...more}
          class={props.optionClass ?? "choice__option"}
          testId={testId}
          pressed={option === value}
          onPress={() => onChange(option)}
        >
          {text}
        </Button>
      ))}
    </fieldset>
  );
}
