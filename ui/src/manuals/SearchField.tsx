import type { Signal } from "@preact/signals";
import { Search } from "lucide-preact";
import type { Ref } from "preact";

interface SearchFieldProps {
  query: Signal<string>;
  label: string;
  testId: string;
  elementRef?: Ref<HTMLInputElement>;
}

/** A field that searches while it is written. */
export function SearchField({ query, label, testId, elementRef }: SearchFieldProps) {
  return (
    <label class="search-field">
      <Search class="icon" aria-hidden="true" />
      <input
        ref={elementRef ?? null}
        class="field"
        type="search"
        aria-label={label}
        placeholder={label}
        spellcheck={false}
        value={query.value}
        data-testid={testId}
        onInput={(event) => {
          query.value = event.currentTarget.value;
        }}
      />
    </label>
  );
}
