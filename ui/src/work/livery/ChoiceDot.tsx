import type { ComponentChildren } from "preact";

interface ChoiceDotProps {
  /** Name of the radio group. */
  group: string;
  label: string;
  chosen: boolean;
  /** Another group of the class has it: dimmed, but available. */
  used?: boolean;
  testId: string;
  value: string;
  onChoose(): void;
  children: ComponentChildren;
}

/** One choice of a radio group that shows what is chosen. */
export function ChoiceDot(props: ChoiceDotProps) {
  const { group, label, chosen, used, testId, value, onChoose, children } = props;
  return (
    <label
      class={`pictures__one ${used ? "pictures__one--taken" : ""}`}
      title={label}
      data-testid={testId}
      data-value={value}
    >
      <input
        type="radio"
        class="visually-hidden"
        name={group}
        aria-label={label}
        checked={chosen}
        onChange={onChoose}
      />
      {children}
    </label>
  );
}
