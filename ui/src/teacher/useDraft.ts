import { useState } from "preact/hooks";

/** The texts typed into a form. `field(name)` gives the props of a `Field`; typing calls `onTyped` too. */
export function useDraft<Name extends string>(initial: Record<Name, string>, onTyped: () => void) {
  const [draft, setDraft] = useState(initial);
  const field = (name: Name) => ({
    value: draft[name],
    onText: (text: string) => {
      onTyped();
      setDraft((now) => ({ ...now, [name]: text }));
    },
  });
  /** Types several texts at once. */
  const fill = (texts: Partial<Record<Name, string>>) => {
    onTyped();
    setDraft((now) => ({ ...now, ...texts }));
  };
  return { draft, field, fill, reset: () => setDraft(initial) };
}
