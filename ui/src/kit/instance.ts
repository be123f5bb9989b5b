import { useEffect, useRef } from "preact/hooks";

/** An object with the lifetime of the component; calls its `dispose`, if any, on unmount. */
export function useInstance<T extends object>(make: () => T): T {
  const made = useRef<T | null>(null);
  made.current ??= make();
  const instance = made.current;
  useEffect(
    () => () => {
      if ("dispose" in instance && typeof instance.dispose === "function") instance.dispose();
    },
    [],
  );
  return instance;
}
