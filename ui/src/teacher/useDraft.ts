import { useState } from "preact/hooks";

/** The texts typed into a form. `field(name)` returns the props of a `Field`; typing also calls `onTyped`. */
export function useDraft<Name extends string>(initial: Record<Name, string>, onTyped: () => void) {
  const [draft, setDraft] = useState(initial);
  const field = (name: Name) => ({
    value: draft[name],
    onText: (text: string) => {
      onTyped();
      setDraft((now) => ({ ...now, [name]: text }));
    },
  });
  /** Sets several texts at once, as if typed. */
  const fill = (texts: Partial<Record<Name, string>>) => {
    onTyped();
    setDraft((now) => ({ ...now, ...texts }));
  };
  return { draft, field, fill, reset: () => setDraft(initial) };
}
