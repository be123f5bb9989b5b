import type { Option } from "./option";

interface TabAttributes {
  title?: string;
  [data: `data-${string}`]: string;
}

interface TabsProps<T> {
  label: string;
  value: T;
  options: readonly Option<T, string, TabAttributes>[];
  onChange(value: T): void;
  testId?: string;
}

/** A tab list; the arrow keys move between tabs and wrap around. */
export function Tabs<T extends string>({ label, value, options, onChange, testId }: TabsProps<T>) {
  return (
    <div class="tabs" role="tablist" aria-label={label} onKeyDown={toOtherTab}>
      {options.map(([option, text, more]) => (
        <button
          key={option}
          {...more}
          type="button"
          class="tab"
          role="tab"
          aria-selected={option === value}
          tabIndex={option === value ? 0 : -1}
          data-testid={testId}
          onClick={() => onChange(option)}
        >
          {text}
        </button>
      ))}
    </div>
  );
}

function toOtherTab(event: KeyboardEvent & { currentTarget: HTMLElement }): void {
  const direction = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
  if (!direction) return;
  event.stopPropagation();
  const tabs = [...event.currentTarget.querySelectorAll<HTMLElement>("[role=tab]")];
  const now = tabs.findIndex((tab) => tab.getAttribute("aria-selected") === "true");
  const other = tabs.at((now + direction) % tabs.length);
  other?.focus();
  other?.click();
}
