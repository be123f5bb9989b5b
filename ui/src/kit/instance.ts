import { useEffect, useRef } from "preact/hooks";

/** An object that is made once and lives as long as the component; its `dispose`, if any, is called at the end. */
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
