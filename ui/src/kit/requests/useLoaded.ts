import { useCallback, useEffect, useLayoutEffect, useRef } from "preact/hooks";
import { useInstance } from "../instance";
import { listen } from "../listen";
import { type Ask, Load, type LoadOptions, type LoadState, type UNCHANGED } from "./load_state";

export interface LoadedOptions<T> extends LoadOptions<T> {
  /** Request made when the window regains focus while a value is shown; by default none. */
  onFocus?: Ask<T | typeof UNCHANGED>;
  /** Debounce: while a value is shown, a new key is requested after this time without changes. */
  debounceMs?: number;
}

/** State of a loaded value. `reload` resolves when the reload has ended. */
export type Loadable<T> = LoadState<T> & { reload(): Promise<void>; set(value: T): void };

/**
 * Loads a value. A new `key`, one value or several, starts a new request; the old value stays until
 * its response. The latest request wins; unmounting aborts it. Failures are reported.
 */
export function useLoaded<T>(
  key: unknown,
  ask: Ask<T>,
  options: LoadedOptions<T> = {},
): Loadable<T> {
  const load = useInstance(() => new Load<T>());
  const latest = useRef({ ask, options });
  latest.current = { ask, options };
  load.options = options;
  const reload = useCallback(() => load.ask((signal) => latest.current.ask(signal)), []);
  const set = useCallback((value: T) => load.set(value), []);
  // runs before the first paint, so that an immediate response is drawn at once
  useLayoutEffect(
    () => {
      const { debounceMs = 0 } = latest.current.options;
      if (debounceMs === 0 || load.state.peek().status !== "ready") return void reload();
      const timer = setTimeout(reload, debounceMs);
      return () => clearTimeout(timer);
    },
    Array.isArray(key) ? key : [key],
  );
  useEffect(() => {
    const comeBack = () => {
      const { onFocus } = latest.current.options;
      const state = load.state.peek();
      if (onFocus && state.status === "ready" && !state.busy) void load.ask(onFocus);
    };
    return listen(window, { focus: comeBack });
  }, []);
  return { ...load.state.value, reload, set };
}
