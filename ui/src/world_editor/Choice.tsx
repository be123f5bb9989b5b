interface ChoiceProps<T> {
  label: string;
  options: readonly (readonly [T, string])[];
  value: T;
  onValue(value: T): void;
  testId?: string;
}

/** One of a few words, all of them in sight. */
export function Choice<T extends string | boolean>(props: ChoiceProps<T>) {
  const { label, options, value, onValue, testId } = props;
  return (
    <fieldset class="choice" aria-label={label}>
      {options.map(([option, word]) => (
        <button
          key={String(option)}
          type="button"
          class="button choice__option"
          aria-pressed={option === value}
          data-testid={testId}
          data-value={String(option)}
          onClick={() => onValue(option)}
        >
          {word}
        </button>
      ))}
    </fieldset>
  );
}
