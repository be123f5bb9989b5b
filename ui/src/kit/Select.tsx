import { ChevronDown, type LucideIcon } from "lucide-preact";
import type { OptionHTMLAttributes, Ref, SelectHTMLAttributes } from "preact";
import type { Option } from "./option";
import { settled } from "./report";

type Value = string | number | null;
export type SelectOption<T> = Option<T, string, OptionHTMLAttributes<HTMLOptionElement>>;

interface OwnProps<T extends Value> {
  /** Accessible name, where no `<label>` encloses it. */
  label?: string | undefined;
  tip?: string | undefined;
  icon?: LucideIcon | undefined;
  /** The selected value; null and "" become an empty string in the DOM. */
  value: T;
  options?: readonly SelectOption<T>[];
  /** Option groups. */
  groups?: readonly (readonly [heading: string, options: readonly SelectOption<T>[]])[];
  class?: string | undefined;
  testId?: string | undefined;
  /**
   * Called with the chosen value. Unless `value` changes at once, the selection reverts. May return
   * a promise; its failure is reported.
   */
  onChange(value: T): unknown;
  elementRef?: Ref<HTMLSelectElement> | undefined;
  title?: never;
  "aria-label"?: never;
  "data-testid"?: never;
}

export type SelectProps<T extends Value> = OwnProps<T> &
  Omit<SelectHTMLAttributes<HTMLSelectElement>, keyof OwnProps<T>>;

/** The browser's native select. */
export function Select<T extends Value>(props: SelectProps<T>) {
  const { label, tip, icon: Icon, value, options = [], groups = [], ...others } = props;
  const { class: more, testId, onChange, elementRef, ...rest } = others;
  const all = [...options, ...groups.flatMap(([, inside]) => inside)];
  return (
    <span class={["select", more].filter(Boolean).join(" ")}>
      {Icon && <Icon class="icon" aria-hidden="true" />}
      <select
        {...rest}
        ref={elementRef ?? null}
        title={tip}
        aria-label={label}
        data-testid={testId}
        value={written(value)}
        onChange={({ currentTarget }) => {
          const chosen = all.find(([one]) => written(one) === currentTarget.value);
          currentTarget.value = written(value);
          if (chosen) void settled(onChange(chosen[0]));
        }}
      >
        <Options of={options} />
        {groups.map(([heading, inside]) => (
          <optgroup key={heading} label={heading}>
            <Options of={inside} />
          </optgroup>
        ))}
      </select>
      <ChevronDown class="icon icon--end" aria-hidden="true" />
    </span>
  );
}

/** A select with its label above. */
export function LabelledSelect<T extends Value>({
  label,
  ...select
}: SelectProps<T> & { label: string }) {
  return (
    <label class="labelled">
      <span class="labelled__label">{label}</span>
      <Select {...select} />
    </label>
  );
}

function Options<T extends Value>({ of }: { of: readonly SelectOption<T>[] }) {
  return of.map(([value, text, more]) => (
    <option key={written(value)} {...more} value={written(value)}>
      {text}
    </option>
  ));
}

const written = (value: Value) => String(value ?? "");
